// The header from C++: samplers, a table in read-only data, a generator of the standard library, a chain.
#include "check.h"

#include <array>
#include <random>
#include <vector>

namespace {

bool from_standard(void *context, std::uint32_t *word)
{
    *word = static_cast<std::uint32_t>((*static_cast<std::mt19937 *>(context))());
    return true;
}

const std::uint32_t words[] = {0x40000000, 0x40000000, 2};
const mw_cdf table = MW_CDF(words);

} // namespace

int main()
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, 42, 54);

    std::vector<std::array<float, 2>> points(1000);
    mw_disk_fill(&rng, reinterpret_cast<float(*)[2]>(points.data()), points.size());
    for (const auto &point : points)
        CHECK(point[0] * point[0] + point[1] * point[1] <= 1.0f);

    std::mt19937 generator(1);
    const mw_source source = {from_standard, &generator};
    mw_normal normal;
    CHECK(mw_normal_init(&normal, 10.0f, 2.0f) == MW_OK);
    mw_moments moments;
    mw_moments_init(&moments);
    for (int i = 0; i < 10000; i++) {
        float x;
        CHECK(mw_normal_draw_from(&normal, &source, &x) == MW_OK);
        mw_moments_push(&moments, x);
    }
    float mean;
    CHECK(mw_moments_mean(&moments, &mean) && std::fabs(mean - 10.0f) < 0.1f);

    CHECK(mw_cdf_draw(&table, &rng).index != 1);

    float threshold = 0.5f;
    const mw_density_1d target = {[](void *context, float x) {
                                      return x < *static_cast<float *>(context) ? 1.0f : 3.0f;
                                  },
                                  &threshold};
    mw_chain_1d chain;
    CHECK(mw_chain_1d_init(&chain, 0.25f, &target) == MW_OK);
    int above = 0;
    for (int i = 0; i < 10000; i++) {
        CHECK(mw_chain_1d_step_uniform(&chain, &target, &rng, nullptr) == MW_OK);
        above += chain.state >= threshold;
    }
    CHECK(above > 7000 && above < 8000);

    const float vertices[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mw_triangle_on_3d triangle;
    CHECK(mw_triangle_on_3d_init(&triangle, vertices) == MW_OK);
    const float flat[3][3] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    CHECK(mw_triangle_on_3d_init(&triangle, flat) == MW_EMPTY);
    return done("C++");
}
