/*
 * Bad input for every warp: parameters, uniforms and points that are NaN, infinite, far out, or any
 * words. A refused init leaves the struct as it was; whatever is accepted gives finite results.
 */
#include "check.h"

enum { ROUNDS = 300 };

static long refusals, accepted;
static mw_pcg32 dice = {1, 1};

static float bad_float(void)
{
    static const float values[] = {0.0f, -0.0f, 1.0f, -1.0f, 0.5f, 2.0f, NAN, INFINITY, -INFINITY,
                                   3e38f, -3e38f, 1e-45f, 1e-30f, 0.1f, 100.0f, 1e10f};
    uint32_t word = mw_pcg32_next(&dice);
    /* Mostly what may be accepted, so that many parameters together are, too. */
    return word & 1 ? (float)(word >> 8) / 16777216.0f * 2.0f : values[word >> 28];
}

static uint32_t bad_uint32_t(void)
{
    static const uint32_t values[] = {0, 1, UINT32_MAX, 0x80000000, 0x7fffffff, 0x10000, 7, 0xffff};
    uint32_t word = mw_pcg32_next(&dice);
    return word & 1 ? mw_pcg32_next(&dice) >> (word >> 27) : values[word >> 29];
}

static int32_t bad_int32_t(void)
{
    return (int32_t)bad_uint32_t();
}

static uint16_t bad_uint16_t(void)
{
    return (uint16_t)bad_uint32_t();
}

static uint64_t bad_uint64_t(void)
{
    return (uint64_t)bad_uint32_t() << 32 | bad_uint32_t();
}

static bool good_float(float density)
{
    return density >= 0.0f && isfinite(density);
}

/* Every word is a density. */
static bool good_uint64_t(uint64_t density)
{
    (void)density;
    return true;
}

static bool is_refusal(mw_error error)
{
    return error >= MW_NOT_FINITE && error <= MW_NOT_A_TABLE;
}

#include "hostile.h"

int main(void)
{
    for (size_t i = 0; i < sizeof hostile / sizeof hostile[0]; i++)
        hostile[i]();
    printf("%zu warps; %ld refused, %ld accepted\n", sizeof hostile / sizeof hostile[0], refusals,
           accepted);
    CHECK(refusals > 10000 && accepted > 1000);
    return done("bad input");
}
