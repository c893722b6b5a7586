/*
 * A sampler of each kind on a bare core: on the line, in the plane, of directions, a table of weights, and without
 * floating point. Each line that is printed is the beginning of a row of tests/golden/golden.csv: the point, its
 * density and its uniforms. `run` compares them.
 */
#include "board.h"
#include "microwarp.h"

/* Input 1 of the table is these uniforms or words, and input 12 is what this generator draws. */
static const float uniforms[2] = {0.125f, 0.625f};
static const uint32_t ends[2] = {UINT32_MAX, UINT32_MAX};
enum { FIXED = 1, DRAWN = 12 };

static mw_pcg32 generator(void)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, 0x5eed + DRAWN, 54);
    return rng;
}

/* ---- A line of text, and what it is made of ---------------------------------------------------- */

static char line[160];
static size_t length;

static void put(char c)
{
    if (length < sizeof line - 1) {
        line[length++] = c;
    }
}

static void begin(const char *subject, int input)
{
    length = 0;
    while (*subject != '\0') {
        put(*subject++);
    }
    put(' ');
    put('#');
    if (input >= 10) {
        put((char)('0' + input / 10));
    }
    put((char)('0' + input % 10));
}

static void word(uint32_t bits)
{
    put(',');
    for (int shift = 28; shift >= 0; shift -= 4) {
        put("0123456789abcdef"[bits >> shift & 15]);
    }
}

static void number(float x)
{
    union {
        float number;
        uint32_t bits;
    } same = {x};
    word(same.bits);
}

static void numbers(const float *x, int count)
{
    for (int i = 0; i < count; ++i) {
        number(x[i]);
    }
}

static void words(const int32_t *x, int count)
{
    for (int i = 0; i < count; ++i) {
        word((uint32_t)x[i]);
    }
}

static void end(void)
{
    line[length] = '\0';
    board_write(line);
    board_write("\n");
}

/* ---- With floating point ------------------------------------------------------------------------ */

static mw_error exponential(int input)
{
    mw_exponential delay;
    mw_error error = mw_exponential_init_from_rate(&delay, 1.5f);
    if (error != MW_OK) {
        return error;
    }
    mw_pcg32 rng = generator();
    float point = input == DRAWN ? mw_exponential_draw(&delay, &rng) : mw_exponential_sample(&delay, uniforms[0]);
    begin("poly Exponential", input);
    number(point);
    number(mw_exponential_pdf(&delay, point));
    number(mw_exponential_invert(&delay, point));
    end();
    return MW_OK;
}

static mw_error disk(int input)
{
    mw_pcg32 rng = generator();
    float point[2], back[2];
    if (input == DRAWN) {
        mw_disk_draw(&rng, point);
    } else {
        mw_disk_sample(uniforms, point);
    }
    mw_disk_invert(point, back);
    begin("poly Disk", input);
    numbers(point, 2);
    number(mw_disk_pdf(point));
    numbers(back, 2);
    end();
    return MW_OK;
}

static mw_error phong_lobe(int input)
{
    mw_phong_lobe lobe;
    mw_error error = mw_phong_lobe_init(&lobe, 50.0f);
    if (error != MW_OK) {
        return error;
    }
    mw_pcg32 rng = generator();
    float point[3], back[2];
    if (input == DRAWN) {
        mw_phong_lobe_draw(&lobe, &rng, point);
    } else {
        mw_phong_lobe_sample(&lobe, uniforms, point);
    }
    mw_phong_lobe_invert(&lobe, point, back);
    begin("poly PhongLobe 50", input);
    numbers(point, 3);
    number(mw_phong_lobe_pdf(&lobe, point));
    numbers(back, 2);
    end();
    return MW_OK;
}

static void selected(mw_selection chosen)
{
    word((uint32_t)chosen.index);
    number(chosen.pmf);
    number(chosen.leftover);
    word(chosen.leftover_bits);
}

static mw_error table(int input)
{
    static const float weights[6] = {0.0f, 1.0f, 1e-6f, 37.0f, 0.3f, 0.0f};
    uint32_t memory[6];
    mw_error error = mw_cdf_build(weights, 6, memory);
    if (error != MW_OK || input == DRAWN) {
        return error;
    }
    const mw_cdf cdf = MW_CDF(memory);
    begin("poly cdf", input);
    selected(mw_cdf_select_uniform(&cdf, uniforms[0]));
    selected(mw_cdf_select(&cdf, 0xa0000000u)); /* the second uniform as a word */
    end();
    return MW_OK;
}

/* ---- Without ------------------------------------------------------------------------------------ */

static mw_error fixed_exponential(int input)
{
    mw_fixed_exponential delay;
    mw_error error = mw_fixed_exponential_init_from_mean(&delay, 20u << 16);
    if (error != MW_OK) {
        return error;
    }
    mw_pcg32 rng = generator();
    uint32_t point =
        input == DRAWN ? mw_fixed_exponential_draw(&delay, &rng) : mw_fixed_exponential_sample(&delay, ends[0]);
    uint64_t density = mw_fixed_exponential_pdf(&delay, point);
    begin("fine Exponential 20", input);
    word(point);
    word((uint32_t)(density >> 32));
    word((uint32_t)density);
    word(mw_fixed_exponential_invert(&delay, point));
    end();
    return MW_OK;
}

static mw_error fixed_disk(int input)
{
    mw_pcg32 rng = generator();
    int32_t point[2];
    uint32_t back[2];
    if (input == DRAWN) {
        mw_fixed_disk_draw(&rng, point);
    } else {
        mw_fixed_disk_sample(ends, point);
    }
    mw_fixed_disk_invert(point, back);
    uint64_t density = mw_fixed_disk_pdf(point);
    begin("fine Disk", input);
    words(point, 2);
    word((uint32_t)(density >> 32));
    word((uint32_t)density);
    word(back[0]);
    word(back[1]);
    end();
    return MW_OK;
}

static mw_error compact_phong_lobe(int input)
{
    mw_compact_phong_lobe lobe;
    mw_error error = mw_compact_phong_lobe_init(&lobe, UINT64_C(50) << 32);
    if (error != MW_OK) {
        return error;
    }
    mw_pcg32 rng = generator();
    int32_t point[3];
    if (input == DRAWN) {
        mw_compact_phong_lobe_draw(&lobe, &rng, point);
    } else {
        mw_compact_phong_lobe_sample(&lobe, ends, point);
    }
    uint64_t density = mw_compact_phong_lobe_pdf(&lobe, point);
    begin("compact PhongLobe 50", input);
    words(point, 3);
    word((uint32_t)(density >> 32));
    word((uint32_t)density);
    end();
    return MW_OK;
}

int main(void)
{
    static mw_error (*const kinds[])(int) = {
        exponential, disk, phong_lobe, table, fixed_exponential, fixed_disk, compact_phong_lobe,
    };
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; ++i) {
        mw_error error = kinds[i](FIXED);
        if (error == MW_OK) {
            error = kinds[i](DRAWN);
        }
        if (error != MW_OK) {
            board_write(mw_error_text(error));
            return 1;
        }
    }
    return 0;
}
