/* More of others.h: rejection, estimators, the grades' verdicts, and the list. */
static void disk_and_ball(four u, int input, struct out *out)
{
    mw_pcg32 rng = generator(input);
    mw_disk_rejection disk;
    mw_ball_rejection ball;
    float point[3];
    uint32_t tries = 0;
    (void)u;
    out->only = LAST;
    mw_disk_rejection_init(&disk);
    mw_ball_rejection_init(&ball);
    mw_error error = mw_disk_rejection_draw(&disk, &rng, point, &tries);
    put_drawn(out, error, tries, point, 2);
    error = mw_ball_rejection_draw(&ball, &rng, point, &tries);
    put_drawn(out, error, tries, point, 3);
}

static void integer_disks(four u, int input, struct out *out)
{
    mw_pcg32 rng = generator(input);
    mw_fixed_disk_rejection fine;
    mw_fixed_disk_rejection_16 halves;
    int32_t point[2];
    uint32_t stirred[4], tries = 0;
    out->only = LAST;
    stir(u, stirred);
    mw_fixed_disk_rejection_init(&fine);
    mw_fixed_disk_rejection_16_init(&halves);
    mw_error error = mw_fixed_disk_rejection_draw(&fine, &rng, point, &tries);
    put_drawn(out, error, tries, point, 2);
    rng = generator(input);
    error = mw_fixed_disk_rejection_16_draw(&halves, &rng, point, &tries);
    put_drawn(out, error, tries, point, 2);
    skip(out, 2);
    verdict(out, mw_fixed_disk_rejection_set_budget(&fine, stirred[3] & 1));
}

static void ziggurats(four u, int input, struct out *out)
{
    mw_pcg32 rng = generator(input);
    mw_ziggurat_standard_normal normal;
    mw_ziggurat_standard_exponential wait;
    float x = 0.0f;
    bool drawn;
    (void)u;
    mw_ziggurat_standard_normal_init(&normal);
    mw_ziggurat_standard_exponential_init(&wait);
    skip(out, 6);
    drawn = mw_ziggurat_standard_normal_draw(&normal, &rng, &x, NULL) == MW_OK;
    put_figure(out, drawn, x);
    drawn = mw_ziggurat_standard_exponential_draw(&wait, &rng, &x, NULL) == MW_OK;
    put_figure(out, drawn, x);
    skip(out, 2);
}

static void scaled_ziggurats(four u, int input, struct out *out)
{
    const uint32_t budget = whole(3.0f * u[2]);
    mw_pcg32 rng = generator(input);
    mw_ziggurat_normal normal;
    mw_ziggurat_exponential wait;
    mw_ziggurat_standard_normal standard;
    mw_ziggurat_standard_exponential unit;
    float x = 0.0f;
    uint32_t tries = 0;
    bool drawn;
    if (made(out, mw_ziggurat_normal_init(&normal, u[0] - 0.5f, 1e3f * u[1]))) {
        drawn = mw_ziggurat_normal_draw(&normal, &rng, &x, &tries) == MW_OK;
        put_uint32_t(out, drawn ? tries : 0);
        skip(out, 1);
        drawn = mw_ziggurat_normal_draw(&normal, &rng, &x, NULL) == MW_OK;
        put_figure(out, drawn, x);
        skip(out, 1);
    }
    if (made(out, mw_ziggurat_exponential_init(&wait, 1e3f * u[1]))) {
        skip(out, 1);
        drawn = mw_ziggurat_exponential_draw(&wait, &rng, &x, NULL) == MW_OK;
        put_figure(out, drawn, x);
        skip(out, 1);
    }
    mw_error error = mw_ziggurat_normal_init(&normal, 1e38f * u[0], 1e37f * (u[1] + 0.25f));
    verdict(out, error == MW_OK ? mw_ziggurat_normal_set_budget(&normal, budget) : error);
    error = mw_ziggurat_exponential_init(&wait, u[3] - 0.25f);
    verdict(out, error == MW_OK ? mw_ziggurat_exponential_set_budget(&wait, budget) : error);
    mw_ziggurat_standard_normal_init(&standard);
    verdict(out, mw_ziggurat_standard_normal_set_budget(&standard, budget));
    mw_ziggurat_standard_exponential_init(&unit);
    expect_error(out, MW_OK, mw_ziggurat_standard_exponential_set_budget(&unit, 1));
    error = mw_ziggurat_standard_exponential_draw(&unit, &rng, &x, &tries);
    put_uint32_t(out, error == MW_OK ? tries : 0xf1);
}

static bool above(void *least, const float x[3])
{
    return x[0] * x[1] * x[2] > *(float *)least;
}

static void region(four u, int input, struct out *out)
{
    static const float low[3] = {-1.0f, 0.0f, 2.0f}, high[3] = {1.0f, 0.5f, 4.0f};
    float least = u[3] - 0.5f, point[3];
    const mw_region_3d inside = {above, &least};
    mw_pcg32 rng = generator(input);
    mw_aabb_3d room;
    uint32_t tries = 0;
    out->only = LAST;
    expect_error(out, MW_OK, mw_aabb_3d_init(&room, low, high));
    mw_error error = mw_region_3d_draw(&room, &inside, 20, &rng, point, &tries);
    put_drawn(out, error, tries, point, 3);
}

static void rejection_verdicts(four u, int input, struct out *out)
{
    const float a = u[0], b = u[1], c = u[2], d = u[3], low[2] = {a, b}, high[2] = {c, d};
    const float origin[3] = {0.0f, 0.0f, 0.0f}, far[3] = {1e13f, 1e13f * a, 1e13f * b};
    mw_disk_rejection disk;
    mw_ball_rejection ball;
    mw_aabb_2d flat;
    mw_aabb_3d room;
    (void)input;
    mw_disk_rejection_init(&disk);
    mw_ball_rejection_init(&ball);
    skip(out, 3);
    verdict(out, mw_disk_rejection_set_budget(&disk, whole(2.0f * d)));
    verdict(out, mw_ball_rejection_set_budget(&ball, whole(2.0f * a)));
    verdict(out, mw_aabb_2d_init(&flat, low, high));
    verdict(out, mw_aabb_3d_init(&room, origin, far));
}

static void rejected_counts(four u, int input, struct out *out)
{
    const float means[3] = {10.0f + 100.0f * u[0], 65536.0f * u[1], 1048576.0f * u[2]};
    for (int i = 0; i < 3; i++) {
        mw_pcg32 rng = generator(input);
        mw_poisson_rejection law;
        uint32_t count, tries = 0;
        if (!made(out, mw_poisson_rejection_init(&law, means[i])))
            continue;
        skip(out, 1);
        mw_error error = mw_poisson_rejection_draw(&law, &rng, &count, &tries);
        put_uint32_t(out, error == MW_OK ? count : 0xf1);
        if (error == MW_OK)
            skip(out, 1);
        else
            put_uint32_t(out, tries);
    }
}

static void rejected_successes(four u, int input, struct out *out)
{
    const uint32_t trials[4] = {word_of(u[0]) >> 22, word_of(u[1]), word_of(u[2]),
            word_of(u[3]) >> 10};
    const float ps[4] = {u[1], u[2], 1e-6f * u[3], 1.0f - 1e-3f * u[0]};
    for (int i = 0; i < 4; i++) {
        mw_pcg32 rng = generator(input);
        mw_binomial_rejection law;
        uint32_t count, tries = 0;
        if (!made(out, mw_binomial_rejection_init(&law, trials[i], ps[i])))
            continue;
        skip(out, 1);
        mw_error error = mw_binomial_rejection_draw(&law, &rng, &count, &tries);
        put_uint32_t(out, error == MW_OK ? count : 0xf1);
        if (error == MW_OK)
            skip(out, 1);
        else
            put_uint32_t(out, tries);
    }
}

/* A number with its density, or the failure with its tries. */
static void put_with_pdf(struct out *out, mw_error error, uint32_t tries, const float *point, int count,
        float pdf)
{
    if (error == MW_OK) {
        put_floats(out, point, count);
        put_float(out, pdf);
    } else {
        put_uint32_t(out, 0xf1);
        put_uint32_t(out, tries);
    }
}

static void gamma_numbers(four u, int input, struct out *out)
{
    const float a = u[0], b = u[1], c = u[2], d = u[3];
    const float shapes[5] = {a, 1.0f + 9.0f * c, 1e6f * d, 1e-3f * b, 1.0f};
    const float scales[5] = {b, 1.0f, a, d, 2.0f};
    for (int i = 0; i < 5; i++) {
        mw_pcg32 rng = generator(input);
        mw_gamma law;
        float x = 0.0f, ln = 0.0f;
        uint32_t tries = 0;
        if (!made(out, i < 4 ? mw_gamma_init(&law, shapes[i], scales[i])
                             : mw_gamma_init_chi_squared(&law, 2.0f)))
            continue;
        skip(out, 1);
        const mw_error error = mw_gamma_draw(&law, &rng, &x, &tries);
        const float pdf = mw_gamma_pdf(&law, x);
        put_with_pdf(out, error, tries, &pdf, 0, pdf);
        if (i == 2 || i == 4)
            continue;
        rng = generator(input);
        put_float(out, mw_gamma_draw_ln(&law, &rng, &ln, NULL) == MW_OK ? ln : 0.0f);
    }
}

static void shares(four u, int input, struct out *out)
{
    const float a = u[0], b = u[1], c = u[2], d = u[3], two[2] = {c, 1.0f - c};
    const float many[4] = {a, d, 1e-3f * b, c}, few[3] = {1.0f + a, 1.0f + b, 100.0f * c};
    mw_pcg32 rng = generator(input);
    mw_beta beta;
    mw_dirichlet_4 four_shares;
    mw_dirichlet_3 three;
    float point[4] = {0};
    uint32_t tries = 0;
    if (made(out, mw_beta_init(&beta, a, b)))
        put_float(out, mw_beta_pdf(&beta, two));
    if (made(out, mw_beta_init(&beta, 1.0f + c, 1e3f * d))) {
        const mw_error error = mw_beta_draw(&beta, &rng, point, &tries);
        put_with_pdf(out, error, tries, point, 2, mw_beta_pdf(&beta, point));
    }
    if (made(out, mw_dirichlet_4_init(&four_shares, many))) {
        rng = generator(input);
        const mw_error error = mw_dirichlet_4_draw(&four_shares, &rng, point, &tries);
        put_with_pdf(out, error, tries, point, 4, mw_dirichlet_4_pdf(&four_shares, point));
    }
    if (made(out, mw_dirichlet_3_init(&three, few))) {
        rng = generator(input);
        const mw_error error = mw_dirichlet_3_draw(&three, &rng, point, &tries);
        put_with_pdf(out, error, tries, point, 3, mw_dirichlet_3_pdf(&three, point));
    }
}

static void von_mises(four u, int input, struct out *out)
{
    const float means[3] = {6.0f * u[0] - 3.0f, 3.0f, 12.0f * u[1] - 6.0f};
    const float concentrations[3] = {20.0f * u[1], 1e-20f * u[2], 1e20f * u[3]};
    for (int i = 0; i < 3; i++) {
        mw_pcg32 rng = generator(input);
        mw_von_mises law;
        float x = 0.0f;
        uint32_t tries = 0;
        if (!made(out, mw_von_mises_init(&law, means[i], concentrations[i])))
            continue;
        skip(out, 1);
        put_float(out, mw_von_mises_pdf(&law, u[0]));
        const mw_error error = mw_von_mises_draw(&law, &rng, &x, &tries);
        put_with_pdf(out, error, tries, &x, 1, mw_von_mises_pdf(&law, x));
    }
}

#define FIGURE(name, of)                          \
    do {                                          \
        bool known = mw_##name((of), &x);         \
        put_figure(out, known, x);                \
    } while (0)

static void moments(four u, int input, struct out *out)
{
    const float a = u[0], b = u[1], c = u[2], d = u[3];
    const float all[7] = {a, b, c, d, 3.0f * a, a + b, 1.0f - c};
    mw_moments moments, other;
    float x = 0.0f;
    (void)input;
    mw_moments_init(&moments);
    mw_moments_init(&other);
    for (int i = 0; i < 7; i++) {
        mw_moments_push(&moments, 1000.0f + all[i]);
        if (i < 5)
            mw_moments_push(&other, 1e-30f * all[i]);
    }
    put_uint32_t(out, (uint32_t)mw_moments_count(&moments));
    put_uint32_t(out, (uint32_t)mw_moments_refused(&moments));
    FIGURE(moments_mean, &moments);
    FIGURE(moments_variance, &moments);
    FIGURE(moments_population_variance, &moments);
    FIGURE(moments_std_dev, &moments);
    FIGURE(moments_standard_error, &moments);
    FIGURE(moments_std_dev, &other);
    mw_moments_merge(&other, &moments);
    FIGURE(moments_mean, &other);
    FIGURE(moments_variance, &other);
    for (int i = 0; i < 37; i++) {
        moments = other;
        mw_moments_merge(&other, &moments);
    }
    put_uint64_t(out, mw_moments_count(&other));
    FIGURE(moments_mean, &other);
    FIGURE(moments_standard_error, &other);
}

static void integral(four u, int input, struct out *out)
{
    mw_integral integral, other;
    float x = 0.0f;
    (void)input;
    mw_integral_init(&integral);
    mw_integral_init(&other);
    for (int i = 0; i < 4; i++) {
        const float f = u[i], pdf = u[(i + 1) % 4];
        mw_integral_push(&integral, f, pdf);
        mw_integral_push(&other, 1e20f * f, pdf + 0.5f);
    }
    FIGURE(integral_estimate, &integral);
    FIGURE(integral_standard_error, &integral);
    skip(out, 2);
    mw_integral_merge(&integral, &other);
    put_uint32_t(out, (uint32_t)mw_integral_count(&integral));
    put_uint32_t(out, (uint32_t)mw_integral_refused(&integral));
    FIGURE(integral_estimate, &integral);
    skip(out, 3);
}

static void ratio(four u, int input, struct out *out)
{
    const float a = u[0], b = u[1], c = u[2], d = u[3];
    const float pairs[5][2] = {{a, b}, {b, c}, {c, d}, {d, a}, {a + b, -0.1f * c}};
    mw_weighted_mean mean, other;
    float x = 0.0f;
    (void)input;
    mw_weighted_mean_init(&mean);
    mw_weighted_mean_init(&other);
    for (int i = 0; i < 5; i++) {
        mw_weighted_mean_push(&mean, 100.0f + pairs[i][0], pairs[i][1]);
        mw_weighted_mean_push(&other, pairs[i][0], 1e10f * pairs[i][1]);
    }
    put_uint32_t(out, (uint32_t)mw_weighted_mean_count(&mean));
    put_uint32_t(out, (uint32_t)mw_weighted_mean_refused(&mean));
    FIGURE(weighted_mean_mean, &mean);
    FIGURE(weighted_mean_standard_error, &mean);
    mw_weighted_mean_merge(&mean, &other);
    put_uint32_t(out, (uint32_t)mw_weighted_mean_count(&mean));
    FIGURE(weighted_mean_mean, &mean);
    FIGURE(weighted_mean_standard_error, &mean);
}

static void heuristics(four u, int input, struct out *out)
{
    const float a = u[0], b = u[1], c = u[2], d = u[3];
    const float pairs[3][2] = {{a, b}, {1e-25f * c, 1e20f * b}, {3e38f * a, 3e38f * d}};
    const uint32_t n = bits_of(c) >> 20;
    (void)input;
    for (int i = 0; i < 3; i++) {
        const float f = pairs[i][0], g = pairs[i][1];
        put_float(out, mw_balance_heuristic(1, f, 1, g));
        put_float(out, mw_balance_heuristic(n, f, 7, g));
        put_float(out, mw_power_heuristic(1, f, 1, g));
        put_float(out, mw_power_heuristic(n, f, 7, g));
    }
}

static void techniques(four u, int input, struct out *out)
{
    const float a = u[0], b = u[1], d = u[3], scales[2] = {1.0f, 3e38f};
    const uint32_t counts[3] = {1, bits_of(u[2]) >> 20, 7};
    (void)input;
    for (int i = 0; i < 2; i++) {
        const float densities[3] = {scales[i] * a, b, scales[i] * d};
        for (size_t own = 0; own < 3; own++) {
            put_float(out, mw_balance_heuristic_of(counts, densities, 3, own));
            put_float(out, mw_power_heuristic_of(counts, densities, 3, own));
        }
    }
}

static void roulettes(four u, int input, struct out *out)
{
    const float chances[4] = {u[0], 1e-4f * u[1], 2.0f * u[2], u[3] - 0.5f};
    (void)input;
    for (int i = 0; i < 4; i++) {
        float weight = 0.0f, least = 0.0f;
        mw_roulette(chances[i], bits_of(u[3]) << 9, &weight);
        mw_roulette(chances[i], 0, &least);
        put_float(out, weight);
        put_float(out, least);
    }
    /* The weight of a chance that is a ratio is not in C. */
    out->only = FIRST;
}

static void put_lights(struct out *out, const mw_light_reservoir *held)
{
    uint32_t item = 99;
    mw_light_reservoir_item(held, &item);
    put_uint32_t(out, item);
    put_uint32_t(out, mw_light_reservoir_count(held));
    put_float(out, mw_light_reservoir_target(held));
    put_float(out, mw_light_reservoir_contribution(held));
}

/* Two streams, of which the first says what it took, where that is asked for. */
static void offer_lights(four u, mw_light_reservoir held[2], mw_pcg32 *rng, struct out *out)
{
    const float targets[5] = {u[0], 1e30f * u[2], 0.0f, u[3], u[1]};
    const float densities[5] = {u[1], u[0], u[3], 1e-30f * u[2], u[0] - 0.5f};
    for (uint32_t i = 0; i < 5; i++) {
        bool taken;
        const mw_error error =
            mw_light_reservoir_offer(&held[0], i, targets[i], densities[i], rng, &taken);
        if (out != NULL && made(out, error))
            put_uint32_t(out, taken);
        mw_light_reservoir_offer(&held[1], i + 8, targets[i] + 0.25f, 0.5f, rng, &taken);
    }
}

static void light_reservoirs(four u, int input, struct out *out)
{
    mw_pcg32 rng = generator(input);
    mw_light_reservoir held[2] = {{{0}}, {{0}}};
    offer_lights(u, held, &rng, out);
    put_lights(out, &held[0]);
    mw_light_reservoir_cap(&held[0], 2);
    put_lights(out, &held[0]);
}

static void merged_lights(four u, int input, struct out *out)
{
    mw_pcg32 rng = generator(input);
    mw_light_reservoir held[2] = {{{0}}, {{0}}};
    bool taken;
    offer_lights(u, held, &rng, NULL);
    if (made(out, mw_light_reservoir_absorb(&held[1], &held[0], u[1], &rng, &taken)))
        put_uint32_t(out, taken);
    put_lights(out, &held[1]);
    mw_light_reservoir_normalise(&held[1], 5);
    put_float(out, mw_light_reservoir_contribution(&held[1]));
    /* Combinations by targets of several places are not in C. */
    out->only = FIRST;
}

#define OF_GRADE(grade)                                                                              \
    static void grade##_verdicts(four u, int input, struct out *out)                                 \
    {                                                                                                \
        mw_pcg32 rng = generator(input);                                                             \
        const uint32_t a = input < WORDS ? words[input][0] : mw_pcg32_next(&rng);                    \
        const uint32_t b = input < WORDS ? words[input][1] : mw_pcg32_next(&rng);                    \
        const uint64_t wide = (uint64_t)a << 32 | b;                                                 \
        const int32_t mean[2] = {(int32_t)a, (int32_t)a};                                            \
        mw_##grade##_cone cone;                                                                      \
        mw_##grade##_phong_lobe lobe;                                                                \
        mw_##grade##_exponential exponential;                                                        \
        mw_##grade##_tent tent;                                                                      \
        mw_##grade##_normal_pair pair;                                                               \
        mw_##grade##_truncated_exponential truncated;                                                \
        mw_fixed_interval_uq16 interval;                                                             \
        (void)u;                                                                                     \
        verdict(out, mw_##grade##_cone_init_from_one_minus_cos(&cone, wide));                        \
        verdict(out, mw_##grade##_cone_init_from_turns(&cone, b));                                   \
        verdict(out, mw_##grade##_phong_lobe_init(&lobe, wide));                                     \
        verdict(out, mw_##grade##_exponential_init_from_mean(&exponential, b));                      \
        verdict(out, mw_##grade##_tent_init(&tent, (int32_t)a));                                     \
        verdict(out, mw_##grade##_normal_pair_init(&pair, mean, (int32_t)(b >> 3)));                 \
        verdict(out, mw_##grade##_truncated_exponential_init_from_mean(&truncated, a, b));           \
        verdict(out, mw_fixed_interval_uq16_init(&interval, a, b));                                  \
        verdict(out, mw_fixed_interval_uq16_init_inclusive(&interval, a, b));                        \
    }

OF_GRADE(fixed)
OF_GRADE(coarse)
OF_GRADE(compact)

static const struct other_subject {
    const char *name;
    void (*put)(four u, int input, struct out *out);
} by_hand[] = {
    {"poly verdicts on the line", verdicts_on_the_line},
    {"poly verdicts on shapes", verdicts_on_shapes},
    {"poly slices", slices},
    {"poly strata", strata},
    {"poly points", points},
    {"poly frame", frame},
    {"poly cdf", cdf},
    {"poly cdf of any weights", cdf_of_any_weights},
    {"poly cdf of integers", cdf_of_integers},
    {"poly alias", alias},
    {"poly select once", select_once},
    {"poly Mixture choices", choices},
    {"poly reservoir", reservoir},
    {"poly piecewise of any weights", pictures},
    {"poly sky and curve of any weights", skies},
    {"poly rejection disk and ball", disk_and_ball},
    {"poly rejection ziggurats", ziggurats},
    {"poly rejection ziggurats scaled", scaled_ziggurats},
    {"poly rejection region", region},
    {"poly rejection verdicts", rejection_verdicts},
    {"poly rejection poisson", rejected_counts},
    {"poly rejection binomial", rejected_successes},
    {"poly rejection gamma", gamma_numbers},
    {"poly rejection shares", shares},
    {"poly rejection von mises", von_mises},
    {"poly moments", moments},
    {"poly integral", integral},
    {"poly ratio", ratio},
    {"poly heuristics", heuristics},
    {"poly techniques", techniques},
    {"poly roulette", roulettes},
    {"poly lamps seen", lamps_seen},
    {"poly draws of places", draws_of_places},
    {"poly masking", masking},
    {"poly masked", masked},
    {"poly light reservoirs", light_reservoirs},
    {"poly light reservoirs merged", merged_lights},
    {"poly integer selections", integer_selections},
    {"poly integer disks", integer_disks},
    {"poly integer resampling", resampling},
    {"poly counts", counts},
    {"poly ranges", ranges},
    {"poly coins", coins},
    {"poly shuffles", shuffles},
    {"poly permutations", permutations},
    {"poly screens", screens},
    {"poly changing weights", trees},
    {"poly binomial counts", successes},
    {"poly integers around", integers_around},
    {"fine verdicts", fixed_verdicts},
    {"coarse verdicts", coarse_verdicts},
    {"compact verdicts", compact_verdicts},
};
