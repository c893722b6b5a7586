/* Lamps seen from a point, and the surface that they light; included by golden.c, behind others.h. */

static const float from_here[3] = {0.0f, 0.0f, 0.0f}, ball_radius = 0.7f;

/* A corner of the panel and of the face, and where from there the others are. */
struct panel {
    float near[3], far[2][3], corners[3][3];
};

static struct panel panel_of(four u)
{
    struct panel made = {{0.5f + u[0], u[1], 2.0f}, {{2.0f, 0.0f, u[2]}, {0.0f, 1.5f, 0.0f}}, {{0.0f}}};
    memcpy(made.corners[0], made.near, sizeof made.near);
    memcpy(made.corners[1], made.far, sizeof made.far);
    return made;
}

static void put_seen(struct out *out, const mw_light_sample *to, float density)
{
    expect_density(out, to->pdf);
    put_float(out, to->distance);
    put_floats(out, to->place, 2);
    put_float(out, density);
}

/* The drawing of a callback is that of the generator. */
static void expect_light(struct out *out, mw_error error, const mw_light_sample *by_source, const mw_light_sample *drawn)
{
    expect_error(out, MW_OK, error);
    expect_same(out, by_source, drawn, sizeof *drawn);
}

static void lamps_seen(four u, int input, struct out *out)
{
    struct panel lamp = panel_of(u);
    mw_pcg32 rng = generator(input), again = generator(input);
    const mw_source source = {from_pcg32, &again};
    mw_visible_sphere ball;
    mw_spherical_rectangle panel;
    mw_spherical_triangle face;
    mw_light_sample to, by_source;
    if (made(out, mw_visible_sphere_init(&ball, from_here, lamp.near, ball_radius))) {
        mw_visible_sphere_draw_light(&ball, &rng, &to);
        expect_light(out, mw_visible_sphere_draw_light_from(&ball, &source, &by_source), &by_source, &to);
        put_seen(out, &to, mw_visible_sphere_density(&ball));
        float point[3];
        mw_visible_sphere_sample_light(&ball, u, &to);
        mw_visible_sphere_sample(&ball, u, point);
        expect_same(out, point, to.direction, sizeof point);
    }
    if (made(out, mw_spherical_rectangle_init(&panel, from_here, lamp.near, (const float(*)[3])lamp.far))) {
        mw_spherical_rectangle_draw_light(&panel, &rng, &to);
        expect_light(out, mw_spherical_rectangle_draw_light_from(&panel, &source, &by_source), &by_source, &to);
        put_seen(out, &to, mw_spherical_rectangle_density(&panel));
        float point[3];
        mw_spherical_rectangle_sample_light(&panel, u, &to);
        mw_spherical_rectangle_sample(&panel, u, point);
        expect_same(out, point, to.direction, sizeof point);
    }
    if (made(out, mw_spherical_triangle_init(&face, from_here, (const float(*)[3])lamp.corners))) {
        mw_spherical_triangle_draw_light(&face, &rng, &to);
        expect_light(out, mw_spherical_triangle_draw_light_from(&face, &source, &by_source), &by_source, &to);
        mw_spherical_triangle_sample_light(&face, u + 2, &to);
        put_seen(out, &to, mw_spherical_triangle_density(&face));
    }
}

static void draws_of_places(four u, int input, struct out *out)
{
    struct panel lamp = panel_of(u);
    const float view[3] = {0.6f, 0.0f, 0.8f}, alpha[2] = {0.3f, 0.1f};
    mw_pcg32 rng = generator(input), again = generator(input);
    const mw_source source = {from_pcg32, &again};
    mw_ggx_visible gloss;
    mw_visible_sphere ball;
    mw_spherical_rectangle panel;
    mw_spherical_triangle face;
    mw_reflection bounce, by_source;
    mw_light_sample to;
    if (made(out, mw_ggx_visible_init(&gloss, view, alpha))) {
        mw_ggx_visible_draw_reflection(&gloss, &rng, &bounce);
        expect_error(out, MW_OK, mw_ggx_visible_draw_reflection_from(&gloss, &source, &by_source));
        expect_same(out, &by_source, &bounce, sizeof bounce);
        put_floats(out, bounce.direction, 3);
        put_float(out, bounce.pdf);
    }
    if (made(out, mw_visible_sphere_init(&ball, from_here, lamp.near, ball_radius))) {
        mw_visible_sphere_draw_light(&ball, &rng, &to);
        put_float(out, to.distance);
    }
    if (made(out, mw_spherical_rectangle_init(&panel, from_here, lamp.near, (const float(*)[3])lamp.far))) {
        mw_spherical_rectangle_draw_light(&panel, &rng, &to);
        put_floats(out, to.place, 2);
    }
    if (made(out, mw_spherical_triangle_init(&face, from_here, (const float(*)[3])lamp.corners))) {
        mw_spherical_triangle_draw_light(&face, &rng, &to);
        skip(out, 1);
        put_floats(out, to.place, 2);
    }
}

static void masking(four u, int input, struct out *out)
{
    const float view[3] = {u[0] - 0.5f, u[1], u[3]};
    const float alpha[2] = {0.05f + 0.9f * u[2], 0.05f + 0.9f * u[3]};
    mw_ggx_visible gloss;
    mw_ggx surface;
    mw_reflection bounce;
    (void)input;
    if (!made(out, mw_ggx_visible_init(&gloss, view, alpha)))
        return;
    mw_ggx_visible_reflect(&gloss, u + 1, &bounce);
    put_float(out, bounce.pdf);
    put_float(out, mw_ggx_visible_reflected_pdf(&gloss, bounce.normal));
    put_float(out, mw_ggx_visible_g1(&gloss));
    put_float(out, mw_ggx_visible_unmasked(&gloss, bounce.direction));
    put_float(out, mw_ggx_visible_visibility(&gloss, bounce.direction));
    if (made(out, mw_ggx_init(&surface, alpha)))
        put_float(out, mw_ggx_distribution(&surface, bounce.normal));
}

static void masked(four u, int input, struct out *out)
{
    const float direction[3] = {u[0] - 0.5f, u[1] - 0.5f, u[3]};
    const float alpha[2] = {0.05f + 0.9f * u[2], 1.0f};
    mw_ggx surface;
    (void)input;
    if (made(out, mw_ggx_init(&surface, alpha)))
        put_float(out, mw_ggx_g1(&surface, direction));
}
