/*
 * The golden subjects that are no warps, as far as C has their functions; included by golden.c, behind its inputs.
 *
 * They follow crates/list/src line by line. `skip` stands for a word of a function that only Rust has; where such words
 * vary in number, `only` says which end of the line is compared.
 */
typedef const float *four;

static void skip(struct out *out, int count)
{
    for (; count > 0; count--) {
        out->skipped |= 1u << out->count;
        put_uint32_t(out, 0);
    }
}

/* Which weight was refused is not said in C. */
static void put_refusal(struct out *out, mw_error error, uint32_t above)
{
    if (error == MW_NOT_FINITE_WEIGHT || error == MW_NEGATIVE_WEIGHT || error == MW_UNREACHABLE)
        skip(out, 1);
    else
        put_uint32_t(out, (uint32_t)error - 1 + above);
}

static void verdict(struct out *out, mw_error error)
{
    if (error == MW_OK)
        put_uint32_t(out, 0);
    else
        put_refusal(out, error, 1);
}

static bool made(struct out *out, mw_error error)
{
    if (error != MW_OK)
        put_refusal(out, error, 0);
    return error == MW_OK;
}

static void put_floats(struct out *out, const float *x, int count)
{
    for (int i = 0; i < count; i++)
        put_float(out, x[i]);
}

static void put_figure(struct out *out, bool known, float x)
{
    put_float(out, known ? x : NAN);
}

static void put_selection(struct out *out, mw_selection chosen)
{
    put_size_t(out, chosen.index);
    put_float(out, chosen.pmf);
    put_float(out, chosen.leftover);
    put_uint32_t(out, chosen.leftover_bits);
}

static void put_exact(struct out *out, mw_exact_selection chosen)
{
    put_size_t(out, chosen.index);
    put_uint64_t(out, chosen.numerator >> 1);
    put_uint32_t(out, chosen.leftover);
    put_uint32_t(out, chosen.leftover_bits);
}

/* A drawn point with its tries, or the failure. */
static void put_drawn(struct out *out, mw_error error, uint32_t tries, const void *point, int count)
{
    uint32_t bits[3];
    if (error != MW_OK)
        put_uint32_t(out, error == MW_BUDGET_SPENT ? 0xf1 : 0xff);
    put_uint32_t(out, tries);
    memcpy(bits, point, sizeof bits[0] * (size_t)count);
    for (int i = 0; error == MW_OK && i < count; i++)
        put_uint32_t(out, bits[i]);
}

/* As Rust casts: NaN is 0, and what is too large the largest. */
static uint32_t whole(float x)
{
    return x > 0.0f ? x < 4294967296.0f ? (uint32_t)x : UINT32_MAX : 0;
}

static uint32_t word_of(float u)
{
    return whole(u * 4294967296.0f);
}

static float grid(int input)
{
    mw_pcg32 rng = generator(input);
    return (float)(mw_pcg32_next(&rng) >> 8) * 0x1p-24f;
}

static void stir(four u, uint32_t stirred[4])
{
    uint32_t rest = 0x9e3779b9u;
    for (int i = 0; i < 4; i++) {
        rest = (rest ^ bits_of(u[i])) * 0x85ebca6bu;
        rest = rest << 13 | rest >> 19;
        stirred[i] = rest;
    }
}

static void verdicts_on_the_line(four u, int input, struct out *out)
{
    const float a = u[0], b = u[1], c = u[2], mean[2] = {a, b};
    (void)input;
    mw_interval interval;
    mw_power power;
    mw_exponential exponential;
    mw_exponential_tail tail;
    mw_truncated_exponential truncated;
    mw_tent tent;
    mw_linear linear;
    mw_normal normal;
    mw_normal_pair pair;
    verdict(out, mw_interval_init(&interval, a, b));
    verdict(out, mw_interval_init_decreasing(&interval, b, c));
    verdict(out, mw_power_init(&power, c - 2.0f, a, b));
    verdict(out, mw_power_init_decreasing(&power, a, b, c));
    verdict(out, mw_exponential_init_from_rate(&exponential, a));
    verdict(out, mw_exponential_tail_init_from_rate(&tail, b - 0.5f));
    verdict(out, mw_truncated_exponential_init_from_rate(&truncated, a, b - 0.5f));
    verdict(out, mw_tent_init(&tent, a));
    verdict(out, mw_linear_init(&linear, a - 0.5f, b));
    verdict(out, mw_normal_init(&normal, a, b));
    verdict(out, mw_normal_pair_init(&pair, mean, c));
}

static void verdicts_on_shapes(four u, int input, struct out *out)
{
    const float a = u[0], b = u[1], c = u[2], d = u[3];
    const float flat[3][2] = {{a, b}, {c, d}, {a, a}}, facet[3][3] = {{a, b, c}, {c, d, b}, {a, a, a}};
    (void)input;
    mw_triangle_on_2d of_plane;
    mw_triangle_on_3d of_space;
    mw_phong_lobe lobe;
    mw_cone cone;
    mw_spherical_patch patch;
    mw_frame frame;
    mw_strata_1d line;
    mw_strata_2d square;
    verdict(out, mw_triangle_on_2d_init(&of_plane, flat));
    verdict(out, mw_triangle_on_3d_init(&of_space, facet));
    verdict(out, mw_phong_lobe_init(&lobe, a - 0.5f));
    verdict(out, mw_cone_init_from_radians(&cone, 4.0f * b));
    verdict(out, mw_cone_init_from_sine(&cone, 2.0f * b));
    verdict(out, mw_cone_init_from_one_minus_cos(&cone, 3.0f * c));
    verdict(out, mw_spherical_patch_init_from_turns(&patch, a, b, c, d));
    skip(out, 1);
    verdict(out, mw_frame_init(&frame, u));
    verdict(out, mw_strata_1d_init(&line, bits_of(a)));
    verdict(out, mw_strata_2d_init(&square, bits_of(a), bits_of(b)));
}

static void frame(four u, int input, struct out *out)
{
    const float normal[3] = {u[0] - 0.5f, u[1] - 0.5f, u[2] - 0.5f};
    const float direction[3] = {u[0], u[1], u[3]};
    float turned[3];
    mw_frame frame;
    (void)input;
    if (!made(out, mw_frame_init(&frame, normal)))
        return;
    skip(out, 3);
    mw_frame_to_world(&frame, direction, turned);
    put_floats(out, turned, 3);
    mw_frame_to_local(&frame, direction, turned);
    put_floats(out, turned, 3);
    skip(out, 6);
}

static void slices(four u, int input, struct out *out)
{
    mw_pcg32 rng = generator(input);
    mw_exponential_tail tail;
    float line[4], plane[3][2];
    (void)u;
    expect_error(out, MW_OK, mw_exponential_tail_init_from_rate(&tail, 2.0f));
    mw_exponential_tail_fill(&tail, &rng, line, 4);
    put_floats(out, line, 4);
    put_uint32_t(out, 0);
    mw_disk_fill(&rng, plane, 3);
    put_floats(out, plane[0], 6);
}

static void strata(four u, int input, struct out *out)
{
    mw_strata_1d line;
    mw_strata_2d square;
    float point[2];
    expect_error(out, MW_OK, mw_strata_1d_init(&line, 7));
    expect_error(out, MW_OK, mw_strata_2d_init(&square, 5, 3));
    put_float(out, mw_strata_1d_point(&line, (uint32_t)input, u[0]));
    mw_strata_2d_point(&square, (uint32_t)input, u, point);
    put_floats(out, point, 2);
    skip(out, 3);
}

static void points(four u, int input, struct out *out)
{
    mw_sobol_2d pairs;
    mw_sobol_8d eight;
    float point[2];
    uint32_t bits[8];
    (void)input;
    expect_error(out, MW_OK, mw_sobol_2d_init(&pairs, bits_of(u[1])));
    expect_error(out, MW_OK, mw_sobol_8d_init(&eight, bits_of(u[1])));
    mw_sobol_2d_point(&pairs, bits_of(u[0]), point);
    put_floats(out, point, 2);
    mw_sobol_2d_words(&pairs, bits_of(u[0]), bits);
    put_uint32_t(out, bits[0]);
    put_uint32_t(out, bits[1]);
    skip(out, 1);
    mw_sobol_8d_words(&eight, bits_of(u[0]), bits);
    for (int i = 0; i < 8; i++)
        put_uint32_t(out, bits[i]);
    skip(out, 1);
}
