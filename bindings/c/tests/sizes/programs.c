/*
 * Programs of one sampler each, with its constructor and a generator.
 *
 * What a compiler could fold stands behind `volatile`: the seed, and parameters, which real programs
 * get from elsewhere. -DPROGRAM=NAME picks one.
 */
#include "microwarp.h"

static volatile uint32_t seed = 42;
static volatile float parameter = 50.0f;
static volatile uint32_t whole = 20u << 16;
static volatile float out[3];
static volatile uint32_t words[2];

static int disk(void)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, seed, 54);
    float point[2];
    mw_disk_draw(&rng, point);
    out[0] = point[0];
    out[1] = point[1];
    return 0;
}

static int exponential(void)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, seed, 54);
    mw_exponential warp;
    mw_error error = mw_exponential_init_from_mean(&warp, parameter);
    if (error != MW_OK)
        return (int)error;
    out[0] = mw_exponential_draw(&warp, &rng);
    return 0;
}

static int normal_pair(void)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, seed, 54);
    const float mean[2] = {parameter, parameter};
    mw_normal_pair warp;
    mw_error error = mw_normal_pair_init(&warp, mean, parameter);
    if (error != MW_OK)
        return (int)error;
    float point[2];
    mw_normal_pair_draw(&warp, &rng, point);
    out[0] = point[0];
    out[1] = point[1];
    return 0;
}

static int phong_lobe(void)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, seed, 54);
    mw_phong_lobe warp;
    mw_error error = mw_phong_lobe_init(&warp, parameter);
    if (error != MW_OK)
        return (int)error;
    float point[3];
    mw_phong_lobe_draw(&warp, &rng, point);
    out[0] = point[0];
    out[1] = point[1];
    out[2] = point[2];
    return 0;
}

/* The words that mw_cdf_build writes for 1, 2, 3 and 4. */
static const uint32_t entries[4] = {0x1999999a, 0x4ccccccd, 0x9999999a, 3};

static int cdf(void)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, seed, 54);
    const mw_cdf table = MW_CDF(entries);
    words[0] = (uint32_t)mw_cdf_draw_index(&table, &rng);
    return 0;
}

static int fixed_disk(void)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, seed, 54);
    int32_t point[2];
    mw_fixed_disk_draw(&rng, point);
    words[0] = (uint32_t)point[0];
    words[1] = (uint32_t)point[1];
    return 0;
}

static int fixed_exponential(void)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, seed, 54);
    mw_fixed_exponential warp;
    mw_error error = mw_fixed_exponential_init_from_mean(&warp, whole);
    if (error != MW_OK)
        return (int)error;
    words[0] = mw_fixed_exponential_draw(&warp, &rng);
    return 0;
}

int main(void)
{
    return PROGRAM();
}
