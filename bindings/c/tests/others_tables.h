/* More of others.h: tables, counts and resampling. */
static const float six[6] = {0.0f, 1.0f, 1e-6f, 37.0f, 0.3f, 0.0f};

static void cdf(four u, int input, struct out *out)
{
    uint32_t bits[6];
    mw_pcg32 rng = generator(input);
    expect_error(out, MW_OK, mw_cdf_build(six, 6, bits));
    const mw_cdf table = MW_CDF(bits);
    put_selection(out, mw_cdf_select_uniform(&table, u[0]));
    put_selection(out, mw_cdf_select(&table, word_of(u[1])));
    put_selection(out, mw_cdf_draw(&table, &rng));
    skip(out, 3);
}

static void cdf_of_any_weights(four u, int input, struct out *out)
{
    const float any[5] = {u[0], u[1], 1e-9f * u[2], u[3], 1e6f * u[0]};
    uint32_t bits[5];
    (void)input;
    out->only = FIRST;
    if (!made(out, mw_cdf_build(any, 5, bits)))
        return;
    const mw_cdf table = MW_CDF(bits);
    for (int i = 0; i < 5; i++)
        put_uint32_t(out, bits[i]);
    put_float(out, mw_cdf_pmf(&table, 0));
}

static void cdf_of_integers(four u, int input, struct out *out)
{
    const uint32_t any[4] = {bits_of(u[0]), bits_of(u[1]) >> 9, bits_of(u[2]) >> 20, bits_of(u[3])};
    uint32_t bits[4];
    (void)input;
    out->only = FIRST;
    if (!made(out, mw_cdf_build_integers(any, 4, bits)))
        return;
    for (int i = 0; i < 4; i++)
        put_uint32_t(out, bits[i]);
}

static void alias(four u, int input, struct out *out)
{
    mw_alias_bin bins[8];
    mw_pcg32 rng = generator(input);
    expect_error(out, MW_OK, mw_alias_build(six, 6, bins));
    const mw_alias table = {bins, 6};
    put_selection(out, mw_alias_select_uniform(&table, u[0]));
    put_selection(out, mw_alias_select(&table, word_of(u[1])));
    put_selection(out, mw_alias_draw(&table, &rng));
    skip(out, 1);
    rng = generator(input);
    put_size_t(out, mw_alias_draw_index(&table, &rng));
    skip(out, 1);
}

static void integer_selections(four u, int input, struct out *out)
{
    static const uint32_t any[6] = {0, 5, 1, 37, 9, 0};
    uint32_t bits[6], stirred[4];
    mw_alias_bin bins[8];
    mw_pcg32 rng = generator(input);
    expect_error(out, MW_OK, mw_cdf_build_integers(any, 6, bits));
    expect_error(out, MW_OK, mw_alias_build_integers(any, 6, bins));
    const mw_cdf searched = MW_CDF(bits);
    const mw_alias alias = {bins, 6};
    stir(u, stirred);
    put_exact(out, mw_cdf_select_exact(&searched, stirred[3]));
    put_exact(out, mw_alias_select_exact(&alias, stirred[3]));
    put_exact(out, mw_cdf_select_exact(&searched, mw_pcg32_next(&rng)));
}

static void select_once(four u, int input, struct out *out)
{
    const float some[4] = {u[1], u[2], 1e-9f * u[3], u[0]}, last[3] = {u[0] - 0.5f, u[1], 0.0f};
    mw_selection chosen;
    (void)input;
    if (made(out, mw_select_once(six, 6, word_of(u[0]), &chosen)))
        put_selection(out, chosen);
    if (made(out, mw_select_once_uniform(some, 4, u[2], &chosen)))
        put_selection(out, chosen);
    if (made(out, mw_select_once(last, 3, 0, &chosen)))
        put_selection(out, chosen);
}

/* A generator behind the rest of the word that chose a part. */
struct led {
    uint32_t first;
    bool taken;
    mw_pcg32 rng;
};

static bool from_led(void *context, uint32_t *word)
{
    struct led *led = context;
    *word = led->taken ? mw_pcg32_next(&led->rng) : led->first;
    led->taken = true;
    return true;
}

static void choices(four u, int input, struct out *out)
{
    const float any[4] = {u[0], fabsf(u[1]), 0.0f, u[2]};
    mw_pcg32 rng = generator(input);
    const uint32_t three[3] = {mw_pcg32_next(&rng), 0, UINT32_MAX};
    mw_tent tent;
    mw_chooser chooser;
    expect_error(out, MW_OK, mw_tent_init(&tent, 1.0f));
    if (!made(out, mw_chooser_init(&chooser, any, 4)))
        return;
    uint32_t left[3];
    for (int i = 0; i < 3; i++) {
        put_size_t(out, mw_chooser_choose(&chooser, three[i], &left[i]));
        put_uint32_t(out, left[i]);
    }
    put_uint32_t(out, (uint32_t)mw_chooser_numerator(&chooser, 1));
    put_float(out, mw_chooser_pmf(&chooser, 3));
    put_float(out, mw_chooser_pdf(&chooser, u));

    /* A point of a mixture of four tents with its density, and one that is drawn. */
    float rest, x, densities[4];
    const size_t part = mw_chooser_choose_uniform(&chooser, u[3], &rest);
    const float its = mw_tent_sample_with_pdf(&tent, rest, &x);
    for (size_t i = 0; i < 4; i++)
        densities[i] = i == part ? its : mw_tent_pdf(&tent, x);
    put_float(out, mw_chooser_pdf(&chooser, densities));
    struct led led = {left[0], false, rng};
    const mw_source source = {from_led, &led};
    expect_error(out, MW_OK, mw_tent_draw_from(&tent, &source, &x));
    put_float(out, x);
}

static void reservoir(four u, int input, struct out *out)
{
    const float offered[4] = {u[0], u[1], 1e30f * u[2], 1e-30f * u[3]};
    mw_pcg32 rng = generator(input);
    mw_reservoir reservoir;
    mw_reservoir_init(&reservoir);
    for (uint32_t i = 0; i < 4; i++) {
        bool taken;
        if (made(out, mw_reservoir_offer(&reservoir, i, offered[i], &rng, &taken)))
            put_uint32_t(out, taken);
    }
    uint32_t item = 99;
    mw_reservoir_item(&reservoir, &item);
    put_uint32_t(out, item);
    put_float(out, mw_reservoir_pmf(&reservoir));
    skip(out, 3);
}

static void pictures(four u, int input, struct out *out)
{
    static const float across[2] = {0.0f, 1.0f};
    const float up[2] = {u[0], 9.0f};
    uint32_t marginal[2], conditional[4];
    mw_piecewise_constant_2d table;
    mw_pcg32 rng = generator(input);
    float point[2];
    out->only = FIRST;
    if (!made(out, mw_piecewise_constant_2d_build(&table, u, 2, 2, across, up, marginal, conditional)))
        return;
    mw_piecewise_constant_2d_draw(&table, &rng, point);
    put_floats(out, point, 2);
    put_float(out, mw_piecewise_constant_2d_pdf(&table, point));
}

static void skies(four u, int input, struct out *out)
{
    const float radiances[6] = {u[0], u[1], u[2], u[3], 0.0f, 1e-3f};
    uint32_t marginal[2], conditional[6];
    mw_lat_long_map sky;
    mw_pcg32 rng = generator(input);
    out->only = FIRST;
    if (!made(out, mw_lat_long_map_build(&sky, radiances, 3, 2, marginal, conditional)))
        return;
    const mw_pixel_sample seen = mw_lat_long_map_draw_pixel(&sky, &rng);
    put_floats(out, seen.direction, 3);
    put_float(out, seen.pdf);
    put_size_t(out, 3 * seen.pixel[1] + seen.pixel[0]);
}

static void counts(four u, int input, struct out *out)
{
    uint32_t stirred[4];
    mw_pcg32 rng = generator(input);
    mw_geometric trials;
    mw_poisson events;
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1], c = stirred[2], d = stirred[3];
    if (made(out, mw_geometric_init_from_ratio(&trials, a >> (b & 31), b | 1))) {
        const uint32_t count = mw_geometric_count(&trials, c);
        put_uint32_t(out, count);
        put_uint32_t(out, mw_geometric_draw(&trials, &rng));
        put_float(out, mw_geometric_pmf(&trials, count));
        skip(out, 1);
    }
    if (made(out, mw_geometric_init(&trials, u[1]))) {
        put_uint32_t(out, mw_geometric_sample(&trials, u[0]));
        put_float(out, mw_geometric_pmf(&trials, d >> 20));
    }
    if (made(out, mw_poisson_init_from_ratio(&events, ((a >> 8) * 81) >> 8, 1 << 16))) {
        const uint32_t count = mw_poisson_count(&events, d);
        put_uint32_t(out, count);
        put_uint32_t(out, mw_poisson_draw(&events, &rng));
        put_float(out, mw_poisson_pmf(&events, count));
        skip(out, 1);
    }
    if (made(out, mw_poisson_init(&events, 90.0f * u[2]))) {
        put_uint32_t(out, mw_poisson_sample(&events, u[3]));
        put_float(out, mw_poisson_pmf(&events, c >> 24));
    }
}

/* The same word again and again. */
static bool from_word(void *context, uint32_t *word)
{
    *word = *(const uint32_t *)context;
    return true;
}

static void ranges(four u, int input, struct out *out)
{
    uint32_t stirred[4], value;
    int32_t number;
    mw_pcg32 rng = generator(input);
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1], c = stirred[2], d = stirred[3], last = a >> (b & 31);
    const mw_source word = {from_word, &stirred[2]};
    if (made(out, mw_up_to_from(&word, last, &value)))
        put_uint32_t(out, value);
    put_uint32_t(out, mw_up_to(&rng, last));
    if (made(out, mw_below_from(&word, last, &value))) {
        uint32_t chosen, rest;
        uint64_t share;
        expect_error(out, MW_OK, mw_below_select(c, last, &chosen, &rest));
        expect_same(out, &chosen, &value, sizeof value);
        put_uint32_t(out, chosen);
        put_uint32_t(out, rest);
        expect_error(out, MW_OK, mw_below_numerator(last, value, &share));
        put_uint64_t(out, share);
        expect_error(out, MW_OK, mw_below_wide(&rng, last, &value));
        put_uint32_t(out, value);
        skip(out, 1);
    }
    const uint32_t shift = b >> 5 & 31;
    if (made(out, mw_range(&rng, (int32_t)c >> shift, (int32_t)d >> shift, &number))) {
        put_uint32_t(out, (uint32_t)number);
        expect_error(out, MW_OK, mw_range_wide(&rng, (int32_t)c >> shift, (int32_t)d >> shift, &number));
        put_uint32_t(out, (uint32_t)number);
    }
    uint64_t large;
    if (made(out, mw_range_u64(&rng, ((uint64_t)a << 32 | c) >> (b & 63), (uint64_t)d << 32 | b, &large))) {
        put_uint64_t(out, large);
        skip(out, 1);
    }
}

static void coins(four u, int input, struct out *out)
{
    uint32_t stirred[4];
    bool given, drawn;
    mw_pcg32 rng = generator(input);
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1], part = stirred[2] >> (b & 31);
    const float p[2] = {u[0], float_of(a >> 2)};
    const mw_source word = {from_word, &stirred[3]};
    for (int i = 0; i < 3; i++) {
        if (!made(out, i < 2 ? mw_chance_from(&word, p[i], &given) : mw_ratio_from(&word, part, b, &given)))
            continue;
        uint64_t share;
        CHECK((i < 2 ? mw_chance_numerator(p[i], &share) : mw_ratio_numerator(part, b, &share)) == MW_OK);
        put_uint64_t(out, share);
        skip(out, 1);
        CHECK((i < 2 ? mw_chance(&rng, p[i], &drawn) : mw_ratio(&rng, part, b, &drawn)) == MW_OK);
        put_uint32_t(out, (uint32_t)given | (uint32_t)drawn << 1);
    }
}

static void trees(four u, int input, struct out *out)
{
    uint32_t stirred[4], all = 0;
    mw_pcg32 rng = generator(input);
    mw_sum_tree tree;
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1], c = stirred[2], d = stirred[3];
    uint32_t weights[6] = {a >> 3, b >> 5, 0, c >> (a & 31) >> 3, 1, d >> 4};
    if (made(out, mw_sum_tree_init(&tree, weights, 6))) {
        put_uint32_t(out, mw_sum_tree_get(&tree, 2));
        mw_sum_tree_set(&tree, 2, d >> 3);
        verdict(out, mw_sum_tree_set(&tree, 4, UINT32_MAX));
        mw_exact_selection chosen;
        if (mw_sum_tree_select_exact(&tree, d, &chosen)) {
            put_size_t(out, chosen.index);
            put_uint32_t(out, (uint32_t)chosen.numerator);
            put_uint32_t(out, chosen.leftover);
        }
        size_t index = 9, places[3];
        uint32_t taken[3];
        mw_sum_tree_draw_index(&tree, &rng, &index);
        put_size_t(out, index);
        put_float(out, mw_sum_tree_pmf(&tree, 1));
        const size_t drawn = mw_sum_tree_draw_distinct(&tree, &rng, places, taken, 3);
        for (size_t i = 0; i < drawn; i++)
            all = all << 4 | (uint32_t)places[i];
        put_uint32_t(out, all);
        mw_sum_tree_into_weights(&tree);
        uint32_t sum = 0;
        for (int i = 0; i < 6; i++)
            sum = (sum << 7 | sum >> 25) ^ weights[i];
        put_uint32_t(out, sum);
    }
    uint64_t wide[4] = {(uint64_t)a << 29, 0, (uint64_t)b << 29, (uint64_t)c << 29};
    mw_sum_tree_64 large;
    size_t index;
    if (made(out, mw_sum_tree_64_init(&large, wide, 4)) &&
        mw_sum_tree_64_index(&large, (uint64_t)d << 32 | a, &index)) {
        put_size_t(out, index);
        skip(out, 2);
    }
    const uint32_t offered[6] = {a, b, c >> 20, d, 0, a >> (b & 31)};
    mw_weighted_place places[3];
    mw_weighted_reservoir kept;
    mw_weighted_reservoir_init(&kept, places, 3);
    for (uint32_t i = 0; i < 6; i++)
        mw_weighted_reservoir_offer(&kept, i, offered[i], &rng);
    all = 0;
    for (uint32_t i = 0, item; mw_weighted_reservoir_item(&kept, i, &item); i++)
        all = all << 4 | item;
    put_uint32_t(out, all);
}

static void successes(four u, int input, struct out *out)
{
    uint32_t stirred[4];
    mw_pcg32 rng = generator(input);
    mw_binomial law;
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1], c = stirred[2], d = stirred[3];
    const uint32_t trials = a >> (22 + (b & 7)), whole = b | 1;
    const uint32_t part = (uint32_t)((uint64_t)c * whole >> 32);
    if (made(out, mw_binomial_init_from_ratio(&law, trials, part, whole))) {
        const uint32_t count = mw_binomial_count(&law, d);
        put_uint32_t(out, count);
        put_uint32_t(out, mw_binomial_draw(&law, &rng));
        put_float(out, mw_binomial_pmf(&law, count));
        skip(out, 1);
    }
    const float p = 1e-7f * u[0];
    if (made(out, mw_binomial_init(&law, c, (d & 1) == 0 ? p : 1.0f - p))) {
        const uint32_t count = mw_binomial_sample(&law, u[3]);
        put_uint32_t(out, count);
        put_float(out, mw_binomial_pmf(&law, count ^ 1));
    }
}

static void integers_around(four u, int input, struct out *out)
{
    uint32_t stirred[4];
    mw_pcg32 rng = generator(input);
    mw_discrete_gaussian peak;
    mw_discrete_laplace tails;
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1], c = stirred[2], d = stirred[3];
    const float centre = ((float)a - 2147483648.0f) * (0.001f * u[1]);
    if (made(out, mw_discrete_gaussian_init(&peak, centre, 20.0f * u[0]))) {
        const int32_t integer = mw_discrete_gaussian_integer(&peak, d);
        put_int32_t(out, integer);
        put_int32_t(out, mw_discrete_gaussian_draw(&peak, &rng));
        put_float(out, mw_discrete_gaussian_pmf(&peak, integer));
        skip(out, 1);
    }
    if (made(out, mw_discrete_laplace_init_from_ratio(&tails, b >> (c & 31), a | 1))) {
        const int32_t integer = mw_discrete_laplace_integer(&tails, d);
        put_int32_t(out, integer);
        put_int32_t(out, mw_discrete_laplace_draw(&tails, &rng));
        put_float(out, mw_discrete_laplace_pmf(&tails, integer));
        skip(out, 1);
    }
    if (made(out, mw_discrete_laplace_init(&tails, 1e4f * u[2]))) {
        put_int32_t(out, mw_discrete_laplace_sample(&tails, u[3]));
        put_float(out, mw_discrete_laplace_pmf(&tails, (int32_t)(d >> 20)));
    }
}

static void resampling(four u, int input, struct out *out)
{
    const float numbers[6] = {u[0], u[1], 0.5f, 1e-20f, u[2], u[3]};
    uint32_t stirred[4], copies[6], sum = 0;
    mw_pcg32 rng = generator(input);
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1], c = stirred[2], d = stirred[3];
    const uint32_t any[6] = {a, 0, b >> (a & 31), c, 1, d >> 8};
    for (int way = 0; way < 3; way++) {
        memcpy(copies, any, sizeof any);
        verdict(out, way == 0   ? mw_resample_systematic(copies, 6, 6, d)
                     : way == 1 ? mw_resample_residual(copies, 6, 6, d)
                                : mw_resample_stratified(copies, 6, 6, &rng));
        sum = 0;
        for (int i = 0; i < 6; i++)
            sum = sum << 4 | copies[i];
        put_uint32_t(out, sum);
        skip(out, 2);
    }
    for (int i = 0; i < 6; i++)
        copies[i] = 9;
    verdict(out, mw_resample_to_integers(numbers, 6, copies));
    sum = 0;
    for (int i = 0; i < 6; i++)
        sum = (sum << 7 | sum >> 25) ^ copies[i];
    put_uint32_t(out, sum);
}
