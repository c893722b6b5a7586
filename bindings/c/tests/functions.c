/*
 * What is no warp: errors, tables, counts, rejection, estimators, chains and points. Golden bits are
 * those of golden.c; here what is drawn from a source is what is drawn, and bad input is refused.
 */
#include "check.h"
/* The weights below, as the tool `table` writes them. */
#include "written_alias.h"
#include "written_cdf.h"

static mw_pcg32 seeded(uint64_t seed)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, seed, 54);
    return rng;
}

static bool near(double x, double expected, double within)
{
    return fabs(x - expected) <= within;
}

static void errors_have_texts(void)
{
    static const mw_error known[] = {
        MW_OK, MW_NOT_FINITE, MW_REVERSED, MW_EMPTY, MW_TOO_LARGE, MW_NOT_POSITIVE, MW_NEGATIVE,
        MW_OUT_OF_RANGE, MW_NOT_NORMALIZABLE, MW_ZERO_LENGTH, MW_NO_WEIGHTS, MW_TOO_MANY_WEIGHTS,
        MW_NOT_FINITE_WEIGHT, MW_NEGATIVE_WEIGHT, MW_ALL_ZERO, MW_UNREACHABLE, MW_NOT_A_TABLE,
        MW_SOURCE_FAILED, MW_BUDGET_SPENT, MW_BOUND_EXCEEDED, MW_BAD_DENSITY,
    };
    const char *unknown = mw_error_text((mw_error)999);
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        CHECK(strcmp(mw_error_text(known[i]), unknown) != 0);
    /* None is missing above: no other number below the library's own has a text. */
    for (int code = 0; code < 999; code++)
        CHECK((strcmp(mw_error_text((mw_error)code), unknown) == 0) == (code > 16));
    CHECK(MW_NOT_POSITIVE == 5 && MW_NEGATIVE_WEIGHT == 13);
}

/* The reference output of PCG32 with seed 42 and stream 54, by its author. */
static void pcg32_is_the_published_one(void)
{
    static const uint32_t published[] = {0xa15c02b7, 0x7b47f409, 0xba1d3330,
                                         0x83d2f293, 0xbfa4784b, 0xcbed606e};
    mw_pcg32 rng = seeded(42);
    for (size_t i = 0; i < 6; i++)
        CHECK(mw_pcg32_next(&rng) == published[i]);
}

/* Integers and coins have the words that are their share, and are refused before a word is drawn. */
static void integers_are_drawn(void)
{
    mw_pcg32 rng = seeded(7), same = seeded(7);
    mw_source source = {from_pcg32, &same}, dry = {fails, NULL};
    for (int i = 0; i < 1000; i++) {
        uint32_t face, face_from;
        int32_t offset, offset_from;
        bool happens, happens_from;
        const uint32_t word = mw_up_to(&rng, UINT32_MAX);
        CHECK(mw_up_to_from(&source, UINT32_MAX, &face_from) == MW_OK && face_from == word);
        CHECK(mw_below(&rng, 6, &face) == MW_OK && face < 6);
        CHECK(mw_below_from(&source, 6, &face_from) == MW_OK && face == face_from);
        CHECK(mw_range(&rng, -2, 2, &offset) == MW_OK && offset >= -2 && offset <= 2);
        CHECK(mw_range_from(&source, -2, 2, &offset_from) == MW_OK && offset == offset_from);
        CHECK(mw_chance(&rng, 0.1f, &happens) == MW_OK);
        CHECK(mw_chance_from(&source, 0.1f, &happens_from) == MW_OK && happens == happens_from);
        CHECK(mw_ratio(&rng, 1, 6, &happens) == MW_OK);
        CHECK(mw_ratio_from(&source, 1, 6, &happens_from) == MW_OK && happens == happens_from);
        float u = mw_uniform(&rng), v;
        CHECK(mw_uniform_from(&source, &v) == MW_OK && u == v && u >= 0.0f && u < 1.0f);
    }
    const mw_pcg32 before = rng;
    uint32_t value = 77;
    int32_t number = 77;
    bool happens = true;
    float u = 77.0f;
    static const struct {
        float p;
        mw_error error;
    } bad[] = {{NAN, MW_NOT_FINITE}, {-1e-30f, MW_NEGATIVE}, {1.0000001f, MW_OUT_OF_RANGE}, {INFINITY, MW_NOT_FINITE}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        CHECK(mw_chance(&rng, bad[i].p, &happens) == bad[i].error && happens);
        CHECK(mw_chance_from(&dry, bad[i].p, &happens) == bad[i].error && happens);
    }
    /* Of six faces two have a word more; every word leaves another of its share. */
    uint64_t all = 0, of_face;
    for (int32_t face = -3; face <= 4; face++) {
        CHECK(mw_range_numerator(-2, 3, face, &of_face) == MW_OK && of_face <= 715827883u);
        CHECK((of_face > 0) == (face >= -2 && face <= 3));
        all += of_face;
    }
    CHECK(all == (uint64_t)1 << 32);
    int32_t top = 77;
    uint32_t least = 77, rest = 77;
    CHECK(mw_range_select(UINT32_MAX, -2, 3, &top, &rest) == MW_OK && top == 3 && rest > UINT32_MAX - 12);
    CHECK(mw_below_select(0, 6, &least, &rest) == MW_OK && least == 0 && rest < 12);
    CHECK(mw_below_select(1, 0, &value, &rest) == MW_EMPTY && mw_range_select(1, 1, 0, &number, &rest) == MW_EMPTY);
    CHECK(mw_below_numerator(0, 0, &of_face) == MW_EMPTY && mw_range_numerator(1, 0, 0, &of_face) == MW_EMPTY);
    CHECK(mw_chance_numerator(NAN, &of_face) == MW_NOT_FINITE && mw_ratio_numerator(2, 1, &of_face) == MW_OUT_OF_RANGE);
    CHECK(of_face == 0 && mw_ratio_numerator(1, 1, &of_face) == MW_OK && of_face == all);
    CHECK(mw_below(&rng, 0, &value) == MW_EMPTY && mw_below_from(&dry, 0, &value) == MW_EMPTY);
    CHECK(mw_range(&rng, 1, 0, &number) == MW_EMPTY && mw_range_from(&dry, 1, 0, &number) == MW_EMPTY);
    CHECK(mw_ratio(&rng, 0, 0, &happens) == MW_NOT_POSITIVE && mw_ratio(&rng, 3, 2, &happens) == MW_OUT_OF_RANGE);
    CHECK(memcmp(&rng, &before, sizeof rng) == 0);
    CHECK(mw_up_to_from(&dry, 5, &value) == MW_SOURCE_FAILED && mw_below_from(&dry, 5, &value) == MW_SOURCE_FAILED);
    CHECK(mw_range_from(&dry, -1, 0, &number) == MW_SOURCE_FAILED);
    CHECK(mw_chance_from(&dry, 0.5f, &happens) == MW_SOURCE_FAILED);
    CHECK(mw_ratio_from(&dry, 1, 2, &happens) == MW_SOURCE_FAILED);
    CHECK(mw_uniform_from(&dry, &u) == MW_SOURCE_FAILED);
    CHECK(value == 77 && number == 77 && happens && u == 77.0f);
    CHECK(mw_up_to(&rng, 0) == 0 && mw_range(&rng, INT32_MIN, INT32_MAX, &number) == MW_OK);
    CHECK(mw_chance(&rng, 0.0f, &happens) == MW_OK && !happens);
    CHECK(mw_chance(&rng, 1.0f, &happens) == MW_OK && happens);
}

enum { ENTRIES = 5 };
static const float weights[ENTRIES] = {0.0f, 1.0f, 2.0f, 0.0f, 5.0f};

/* In flash: the words of the weights 1, 0, 3. */
static const uint32_t words_in_flash[] = {0x40000000, 0x40000000, 2};
static const mw_cdf table_in_flash = MW_CDF(words_in_flash);

static void tables_select(void)
{
    uint32_t words[ENTRIES];
    mw_alias_bin bins[8];
    mw_cdf cdf;
    mw_alias alias;
    CHECK(mw_cdf_build(weights, ENTRIES, words) == MW_OK);
    CHECK(mw_cdf_init(&cdf, words, ENTRIES) == MW_OK);
    CHECK(mw_alias_build(weights, ENTRIES, bins) == MW_OK);
    CHECK(mw_alias_init(&alias, bins, ENTRIES) == MW_OK);
    CHECK(written_cdf.entries == ENTRIES && memcmp(written_cdf.words, words, sizeof words) == 0);
    CHECK(written_alias.entries == ENTRIES && memcmp(written_alias.bins, bins, sizeof bins) == 0);
    mw_cdf checked;
    CHECK(mw_cdf_init(&checked, words_in_flash, 3) == MW_OK);
    mw_pcg32 rng = seeded(1), same = seeded(1);
    mw_source source = {from_pcg32, &rng}, dry = {fails, NULL};
    for (int i = 0; i < 100; i++) {
        CHECK(mw_cdf_draw(&cdf, &rng).index == mw_cdf_draw_index(&cdf, &same));
        CHECK(mw_alias_draw(&alias, &rng).index == mw_alias_draw_index(&alias, &same));
    }
    for (size_t i = 0; i < ENTRIES; i++)
        CHECK(mw_cdf_pmf(&cdf, i) == weights[i] / 8.0f && mw_alias_pmf(&alias, i) == weights[i] / 8.0f);
    mw_selection chosen = mw_cdf_select(&cdf, 0x20000000);
    CHECK(chosen.index == 2 && chosen.pmf == 0.25f && chosen.leftover == 0.0f);
    chosen = mw_cdf_select_uniform(&cdf, 0.0f);
    CHECK(chosen.index == 1 && chosen.pmf == 0.125f);
    mw_exact_selection exact = mw_cdf_select_exact(&cdf, 0xffffffff);
    CHECK(exact.index == 4 && exact.numerator == (uint64_t)5 << 29);
    exact = mw_alias_select_exact(&alias, 0);
    CHECK(exact.numerator > 0 && mw_alias_select(&alias, 0).index == exact.index);
    chosen.index = 77;
    CHECK(mw_cdf_draw_from(&cdf, &dry, &chosen) == MW_SOURCE_FAILED && chosen.index == 77);
    CHECK(mw_alias_draw_from(&alias, &source, &chosen) == MW_OK && chosen.index < ENTRIES);
    CHECK(mw_alias_select_uniform(&alias, NAN).index < ENTRIES);

    CHECK(mw_cdf_pmf(&table_in_flash, 0) == 0.25f && mw_cdf_pmf(&table_in_flash, 2) == 0.75f);
    CHECK(mw_cdf_select(&table_in_flash, 0x40000000).index == 2);
    CHECK(mw_cdf_draw_index(&table_in_flash, &rng) != 1);
}

static void tables_refuse(void)
{
    uint32_t words[ENTRIES] = {7, 7, 7, 7, 7};
    mw_alias_bin bins[8] = {{7, 7, 7}};
    mw_cdf cdf = {words, 1};
    mw_alias alias = {bins, 1};
    static const struct {
        float weights[3];
        size_t entries;
        mw_error error;
    } bad[] = {
        {{1.0f, -1.0f, 1.0f}, 3, MW_NEGATIVE_WEIGHT}, {{1.0f, 1.0f, NAN}, 3, MW_NOT_FINITE_WEIGHT},
        {{INFINITY, 1.0f, 1.0f}, 3, MW_NOT_FINITE_WEIGHT}, {{0.0f, 0.0f, 0.0f}, 3, MW_ALL_ZERO},
        {{1.0f, 1.0f, 1.0f}, 0, MW_NO_WEIGHTS},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        CHECK(mw_cdf_build(bad[i].weights, bad[i].entries, words) == bad[i].error && words[0] == 7);
        CHECK(mw_alias_build(bad[i].weights, bad[i].entries, bins) == bad[i].error);
        CHECK(bins[0].threshold == 7);
    }
    static const uint32_t none[3] = {0, 0, 0};
    CHECK(mw_cdf_build_integers(none, 3, words) == MW_ALL_ZERO);
    CHECK(mw_alias_build_integers(none, 3, bins) == MW_ALL_ZERO);
    CHECK(mw_cdf_build_integers(NULL, 0, NULL) == MW_NO_WEIGHTS);
    CHECK(mw_alias_build_integers(NULL, 0, NULL) == MW_NO_WEIGHTS);
    static const uint32_t falling[3] = {9, 8, UINT32_MAX};
    CHECK(mw_cdf_init(&cdf, falling, 3) == MW_NOT_A_TABLE && cdf.words == words);
    CHECK(mw_cdf_init(&cdf, falling, 0) == MW_NO_WEIGHTS);
    static const mw_alias_bin wild[2] = {{5, 6, 99}, {0, 0, 0}};
    CHECK(mw_alias_init(&alias, wild, 2) == MW_NOT_A_TABLE && alias.bins == bins);
    CHECK(mw_alias_init(&alias, wild, 0) == MW_NO_WEIGHTS);
    CHECK(mw_alias_init(&alias, wild, SIZE_MAX) == MW_TOO_MANY_WEIGHTS);
    mw_selection chosen;
    CHECK(mw_select_once(weights, ENTRIES, 0, &chosen) == MW_OK && chosen.index == 1);
    CHECK(mw_select_once_uniform(weights, ENTRIES, 0.99f, &chosen) == MW_OK && chosen.index == 4);
    CHECK(mw_select_once(weights, 0, 0, &chosen) == MW_NO_WEIGHTS && chosen.index == 4);
    CHECK(mw_select_once_uniform(weights, 0, 0.5f, &chosen) == MW_NO_WEIGHTS);
}

/* Of 32 bits and of 64: the weights 3, 0, 5 and 8 of so many, whose words begin with the same four bits. */
#define A_TREE(tree, uint, UNIT, MOST)                                                          \
    static void tree##_changes(void)                                                            \
    {                                                                                           \
        const uint unit = UNIT, quarter = MOST / 16 * 3 + 3;                                    \
        uint changing[4] = {3 * unit, 0, 5 * unit, 8 * unit}, taken[4];                         \
        size_t index = 9, places[4];                                                            \
        mw_##tree of = {0};                                                                     \
        mw_pcg32 rng = seeded(5);                                                               \
        mw_source source = {from_pcg32, &rng}, dry = {fails, NULL};                             \
        mw_selection chosen;                                                                    \
        CHECK(mw_##tree##_init(&of, NULL, 0) == MW_NO_WEIGHTS && mw_##tree##_total(&of) == 0);  \
        CHECK(!mw_##tree##_index(&of, 0, &index) && index == 9);                                \
        CHECK(mw_##tree##_set(&of, 0, 1) == MW_NO_WEIGHTS);                                     \
        CHECK(mw_##tree##_init(&of, changing, 4) == MW_OK && mw_##tree##_total(&of) == 16 * unit); \
        CHECK(mw_##tree##_index(&of, quarter, &index) && index == 2);                           \
        CHECK(mw_##tree##_index(&of, quarter - 1, &index) && index == 0);                       \
        CHECK(mw_##tree##_select(&of, quarter, &chosen) && chosen.index == 2);                  \
        CHECK(chosen.pmf == 0.3125f && chosen.leftover == 0.0f && mw_##tree##_pmf(&of, 3) == 0.5f); \
        CHECK(mw_##tree##_set(&of, 1, MOST - 16 * unit + 1) == MW_TOO_LARGE);                   \
        CHECK(mw_##tree##_set(&of, 4, 0) == MW_OUT_OF_RANGE && mw_##tree##_total(&of) == 16 * unit); \
        CHECK(mw_##tree##_draw_from(&of, &source, &chosen) == MW_OK && chosen.index != 1);      \
        CHECK(mw_##tree##_draw_from(&of, &dry, &chosen) == MW_SOURCE_FAILED);                   \
        CHECK(mw_##tree##_set(&of, 3, 0) == MW_OK && mw_##tree##_get(&of, 3) == 0);             \
        CHECK(mw_##tree##_get(&of, 2) == 5 * unit);                                             \
        CHECK(mw_##tree##_draw_distinct(&of, &rng, places, taken, 4) == 2);                     \
        CHECK(places[0] + places[1] == 2 && taken[0] + taken[1] == 8 * unit);                   \
        CHECK(mw_##tree##_total(&of) == 8 * unit);                                              \
        CHECK(mw_##tree##_draw(&of, &rng, &chosen) && (chosen.index == 0 || chosen.index == 2)); \
        CHECK(mw_##tree##_draw_index(&of, &rng, &index) && (index == 0 || index == 2));         \
        CHECK(mw_##tree##_set(&of, 0, 0) == MW_OK && mw_##tree##_set(&of, 2, 0) == MW_OK);      \
        CHECK(mw_##tree##_draw_from(&of, &source, &chosen) == MW_ALL_ZERO);                     \
        CHECK(mw_##tree##_set(&of, 2, unit) == MW_OK);                                          \
        mw_##tree##_into_weights(&of);                                                          \
        CHECK(changing[0] == 0 && changing[1] == 0 && changing[2] == unit && changing[3] == 0); \
    }

A_TREE(sum_tree, uint32_t, 1, UINT32_MAX)
A_TREE(sum_tree_64, uint64_t, UINT64_C(1) << 40, UINT64_MAX)

static void a_tree_is_exact(void)
{
    uint32_t changing[4] = {3, 0, 5, 8};
    mw_sum_tree tree;
    mw_exact_selection exact;
    CHECK(mw_sum_tree_init(&tree, changing, 4) == MW_OK);
    CHECK(mw_sum_tree_select_exact(&tree, UINT32_MAX, &exact) && exact.index == 3);
    CHECK(exact.numerator == 1u << 31 && mw_sum_tree_numerator(&tree, 0) == 3u << 28);
}

/* By two words, and of 64 bits: the same from a source, the ends, and what is refused. */
static void integers_by_two_words(void)
{
    mw_pcg32 rng = seeded(9), same = seeded(9);
    mw_source source = {from_pcg32, &same}, dry = {fails, NULL};
    uint32_t face = 77, face_from;
    int32_t offset, offset_from;
    uint64_t large = 77, large_from;
    for (int i = 0; i < 1000; i++) {
        CHECK(mw_below_wide(&rng, 6, &face) == MW_OK && face < 6);
        CHECK(mw_below_wide_from(&source, 6, &face_from) == MW_OK && face == face_from);
        CHECK(mw_range_wide(&rng, -2, 2, &offset) == MW_OK && offset >= -2 && offset <= 2);
        CHECK(mw_range_wide_from(&source, -2, 2, &offset_from) == MW_OK && offset == offset_from);
        CHECK(mw_range_u64(&rng, 5, UINT64_C(1) << 40, &large) == MW_OK && large >= 5 && large >> 40 <= 1);
        CHECK(mw_range_u64_from(&source, 5, UINT64_C(1) << 40, &large_from) == MW_OK && large == large_from);
    }
    /* All integers of 64 bits: the two words themselves, the leading one first. */
    same = rng;
    CHECK(mw_range_u64(&rng, 0, UINT64_MAX, &large) == MW_OK);
    const uint64_t high = mw_pcg32_next(&same);
    CHECK(large == (high << 32 | mw_pcg32_next(&same)));
    const mw_pcg32 before = rng;
    large = face = 77;
    CHECK(mw_range_u64(&rng, 1, 0, &large) == MW_EMPTY && mw_range_u64_from(&dry, 1, 0, &large) == MW_EMPTY);
    CHECK(mw_below_wide(&rng, 0, &face) == MW_EMPTY && mw_below_wide_from(&dry, 0, &face) == MW_EMPTY);
    CHECK(mw_range_wide(&rng, 1, 0, &offset) == MW_EMPTY && mw_range_wide_from(&dry, 1, 0, &offset) == MW_EMPTY);
    CHECK(mw_range_u64_from(&dry, 0, 1, &large) == MW_SOURCE_FAILED && large == 77);
    CHECK(mw_below_wide_from(&dry, 6, &face) == MW_SOURCE_FAILED && face == 77);
    CHECK(mw_range_wide_from(&dry, 0, 1, &offset) == MW_SOURCE_FAILED);
    CHECK(memcmp(&rng, &before, sizeof rng) == 0);
}

/* What is held is what the same words hold in parts that are merged, and the heaviest comes first. */
static void streams_are_weighted(void)
{
    enum { ITEMS = 40, HELD = 5 };
    static mw_weighted_place zeros[HELD];
    mw_weighted_place memory[4][HELD];
    mw_weighted_reservoir whole, same, parts[2], none = {NULL, 0};
    mw_weighted_reservoir of_zeros = {zeros, HELD};
    uint32_t item = 77, other;
    bool taken = true;
    mw_pcg32 rng = seeded(3), again = seeded(3);
    mw_source source = {from_pcg32, &again}, dry = {fails, NULL};
    mw_weighted_reservoir_init(&whole, memory[0], HELD);
    mw_weighted_reservoir_init(&same, memory[1], HELD);
    mw_weighted_reservoir_init(&parts[0], memory[2], HELD);
    mw_weighted_reservoir_init(&parts[1], memory[3], HELD);
    CHECK(!mw_weighted_reservoir_item(&whole, 0, &item) && item == 77);
    CHECK(!mw_weighted_reservoir_offer(&none, 1, 1, &again) && !mw_weighted_reservoir_item(&none, 0, &item));
    again = rng;
    for (uint32_t i = 0; i < ITEMS; i++) {
        const uint32_t weight = i % 7, word = mw_pcg32_next(&rng);
        const bool held = mw_weighted_reservoir_offer_with(&whole, i, weight, word);
        CHECK(mw_weighted_reservoir_offer_from(&same, i, weight, &source, &taken) == MW_OK && taken == held);
        CHECK(mw_weighted_reservoir_offer_with(&of_zeros, i, weight, word) == held && (weight > 0 || !held));
        mw_weighted_reservoir_offer_with(&parts[i % 2], i, weight, word);
    }
    mw_weighted_reservoir_merge(&parts[0], &parts[1]);
    for (size_t i = 0; i < HELD; i++) {
        CHECK(mw_weighted_reservoir_item(&whole, i, &item) && item % 7 != 0);
        CHECK(mw_weighted_reservoir_item(&same, i, &other) && other == item);
        CHECK(mw_weighted_reservoir_item(&parts[0], i, &other) && other == item);
        CHECK(mw_weighted_reservoir_item(&of_zeros, i, &other) && other == item);
    }
    CHECK(!mw_weighted_reservoir_item(&whole, HELD, &item));
    CHECK(mw_weighted_reservoir_offer_from(&same, 1, 1, &dry, &taken) == MW_SOURCE_FAILED);
    /* Of two of the same time the first is held, also when a third comes before both. Merging with itself changes nothing. */
    mw_weighted_reservoir_init(&whole, memory[0], 2);
    for (uint32_t i = 0; i < 3; i++)
        CHECK(mw_weighted_reservoir_offer_with(&whole, i, 1, i < 2 ? 100 : 200));
    mw_weighted_reservoir_merge(&whole, &whole);
    CHECK(mw_weighted_reservoir_item(&whole, 0, &item) && item == 2);
    CHECK(mw_weighted_reservoir_item(&whole, 1, &item) && item == 0);
}

static void parts_are_chosen(void)
{
    static const float quarters[3] = {1.0f, 0.0f, 3.0f}, thirds[3] = {1.0f, 1.0f, 1.0f};
    static const float many[33] = {1.0f, [31] = 1.0f, 1.0f}, tiny[3] = {1.0f, 1e-30f, 1e-30f};
    mw_chooser chooser, before;
    uint32_t rest;
    float left;
    CHECK(mw_chooser_init(&chooser, quarters, 3) == MW_OK);
    CHECK(mw_chooser_numerator(&chooser, 0) == 1u << 30 && mw_chooser_numerator(&chooser, 2) == 3u << 30);
    CHECK(mw_chooser_numerator(&chooser, 1) == 0 && mw_chooser_numerator(&chooser, SIZE_MAX) == 0);
    CHECK(mw_chooser_pmf(&chooser, 2) == 0.75f && mw_chooser_pmf(&chooser, 1) == 0.0f);
    CHECK(mw_chooser_pmf(&chooser, 3) == 0.0f && mw_chooser_pmf(&chooser, SIZE_MAX) == 0.0f);
    CHECK(mw_chooser_choose(&chooser, 0x3fffffff, &rest) == 0 && rest == 0xfffffffe);
    CHECK(mw_chooser_choose(&chooser, 0x40000000, &rest) == 2 && rest == 0);
    CHECK(mw_chooser_choose(&chooser, 0xa0000000, &rest) == 2 && rest >> 1 == 0x40000000);
    CHECK(mw_chooser_choose_uniform(&chooser, 0x1p-40f, &left) == 0 && left == 0x1p-38f);
    CHECK(mw_chooser_choose_uniform(&chooser, 0.25f, &left) == 2 && left == 0.0f);
    CHECK(mw_chooser_choose_uniform(&chooser, NAN, &left) == 0 && left == 0.0f);
    CHECK(mw_chooser_choose_uniform(&chooser, INFINITY, &left) == 2 && left < 1.0f && left > 0.9999f);
    /* No density is negative, and that of a part without weight, or of none, is not read. */
    const float one[1] = {2.0f}, sunk[3] = {-1.0f, 5.0f, NAN};
    CHECK(mw_chooser_pdf(&chooser, quarters) == 2.5f && mw_chooser_pdf(&chooser, sunk) == 0.0f);
    CHECK(mw_chooser_init(&chooser, tiny, 1) == MW_OK && mw_chooser_pdf(&chooser, one) == 2.0f);
    /* Of three equal parts one has a word more, and each leaves rests from the least to the largest. */
    CHECK(mw_chooser_init(&chooser, thirds, 3) == MW_OK);
    uint64_t start = 0;
    for (size_t part = 0; part < 3; part++) {
        const uint64_t count = mw_chooser_numerator(&chooser, part);
        CHECK(count - 1431655765u <= 1);
        CHECK(mw_chooser_choose(&chooser, (uint32_t)start, &rest) == part && rest < 3);
        CHECK(mw_chooser_choose(&chooser, (uint32_t)(start + count - 1), &rest) == part && rest > UINT32_MAX - 3);
        start += count;
    }
    CHECK(start == (uint64_t)1 << 32);
    CHECK(mw_chooser_init(&chooser, many, 32) == MW_OK && mw_chooser_choose(&chooser, UINT32_MAX, &rest) == 31);

    before = chooser;
    static const float below[2] = {1.0f, -1.0f}, none[2] = {NAN, 1.0f}, zeros[2] = {0.0f, -0.0f};
    CHECK(mw_chooser_init(&chooser, NULL, 0) == MW_NO_WEIGHTS);
    CHECK(mw_chooser_init(&chooser, many, 33) == MW_TOO_MANY_WEIGHTS);
    CHECK(mw_chooser_init(&chooser, NULL, SIZE_MAX) == MW_TOO_MANY_WEIGHTS);
    CHECK(mw_chooser_init(&chooser, below, 2) == MW_NEGATIVE_WEIGHT);
    CHECK(mw_chooser_init(&chooser, none, 2) == MW_NOT_FINITE_WEIGHT);
    CHECK(mw_chooser_init(&chooser, zeros, 2) == MW_ALL_ZERO && mw_chooser_init(&chooser, tiny, 3) == MW_UNREACHABLE);
    CHECK(memcmp(&chooser, &before, sizeof chooser) == 0);
}

static void maps_are_warps(void)
{
    uint32_t words[ENTRIES], marginal[2], conditional[6];
    mw_piecewise_constant_1d cells, again;
    CHECK(mw_piecewise_constant_1d_build(&cells, weights, ENTRIES, 0.0f, 5.0f, words) == MW_OK);
    CHECK(mw_piecewise_constant_1d_pdf(&cells, 4.5f) == 0.625f);
    CHECK(mw_piecewise_constant_1d_pdf(&cells, 3.5f) == 0.0f);
    CHECK(mw_piecewise_constant_1d_init(&again, words, ENTRIES, 0.0f, 5.0f) == MW_OK);
    float x = mw_piecewise_constant_1d_sample(&again, 0.5f);
    CHECK(x >= 4.0f && x < 5.0f && x == mw_piecewise_constant_1d_sample(&cells, 0.5f));
    CHECK(near((double)mw_piecewise_constant_1d_invert(&cells, x), 0.5, 1e-6));
    CHECK(mw_piecewise_constant_1d_init_trusted(&again, words, ENTRIES, 1.0f, 0.0f) == MW_REVERSED);
    CHECK(mw_piecewise_constant_1d_init_trusted(&again, words, ENTRIES, 0.0f, 5.0f) == MW_OK);
    CHECK(mw_piecewise_constant_1d_build(&cells, weights, ENTRIES, 0, NAN, words) == MW_NOT_FINITE);
    words[1] = 0xffffff;
    words[2] = 1;
    CHECK(mw_piecewise_constant_1d_init(&again, words, ENTRIES, 0.0f, 5.0f) == MW_NOT_A_TABLE);

    mw_piecewise_linear_1d curve;
    static const float ramp[3] = {0.0f, 1.0f, 0.0f};
    CHECK(mw_piecewise_linear_1d_build(&curve, ramp, 3, -1.0f, 1.0f, words) == MW_OK);
    CHECK(near((double)mw_piecewise_linear_1d_pdf(&curve, 0.0f), 1.0, 1e-6));
    CHECK(mw_piecewise_linear_1d_init(&curve, words, ramp, 3, -1.0f, 1.0f) == MW_OK);
    CHECK(near((double)mw_piecewise_linear_1d_sample(&curve, 0.5f), 0.0, 1e-6));
    static const float negative[3] = {0.0f, -1.0f, 0.0f};
    CHECK(mw_piecewise_linear_1d_init(&curve, words, negative, 3, 0, 1) == MW_NEGATIVE_WEIGHT);
    CHECK(mw_piecewise_linear_1d_build(&curve, negative, 3, 0, 1, words) == MW_NEGATIVE_WEIGHT);

    mw_piecewise_constant_2d picture;
    static const float pixels[6] = {0, 1, 0, 1, 2, 0}, u[2] = {0, 3}, v[2] = {0, 2};
    float point[2], uniforms[2] = {0.9f, 0.9f};
    CHECK(mw_piecewise_constant_2d_build(&picture, pixels, 3, 2, u, v, marginal, conditional) == MW_OK);
    static const float corner[2] = {1.5f, 1.5f};
    CHECK(mw_piecewise_constant_2d_pdf(&picture, corner) == 0.5f);
    mw_piecewise_constant_2d_sample(&picture, uniforms, point);
    CHECK(mw_piecewise_constant_2d_pdf(&picture, point) > 0.0f);
    mw_piecewise_constant_2d_invert(&picture, point, point);
    CHECK(near((double)point[0], 0.9, 1e-5) && near((double)point[1], 0.9, 1e-5));
    CHECK(mw_piecewise_constant_2d_init(&picture, marginal, conditional, 3, 2, u, v) == MW_OK);
    CHECK(mw_piecewise_constant_2d_init_trusted(&picture, marginal, conditional, 3, 2, v, u) == MW_OK);
    CHECK(mw_piecewise_constant_2d_init(&picture, marginal, conditional, SIZE_MAX, 2, u, v) ==
          MW_TOO_MANY_WEIGHTS);
    CHECK(mw_piecewise_constant_2d_build(&picture, pixels, 0, 2, u, v, marginal, conditional) != MW_OK);

    mw_lat_long_map sky;
    CHECK(mw_lat_long_map_build(&sky, pixels, 3, 2, marginal, conditional) == MW_OK);
    mw_pcg32 rng = seeded(3);
    for (int i = 0; i < 100; i++) {
        mw_pixel_sample seen = mw_lat_long_map_draw_pixel(&sky, &rng);
        CHECK(seen.pixel[0] < 2 && seen.pixel[1] < 2 && seen.pdf > 0.0f);
        CHECK(near((double)mw_lat_long_map_pdf(&sky, seen.direction), (double)seen.pdf,
                   1e-5 * (double)seen.pdf));
    }
    CHECK(mw_lat_long_map_sample_pixel(&sky, uniforms).pdf > 0.0f);
    CHECK(mw_lat_long_map_init(&sky, marginal, conditional, 3, 2) == MW_OK);
    CHECK(mw_lat_long_map_init_trusted(&sky, marginal, conditional, 0, 2) == MW_NO_WEIGHTS);

    static const float vertices[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    static const uint32_t faces[2][3] = {{0, 1, 2}, {1, 3, 2}};
    static const uint16_t short_faces[2][3] = {{0, 1, 2}, {1, 3, 2}}, beyond[1][3] = {{0, 1, 4}};
    mw_mesh mesh;
    mw_mesh_u16 short_mesh;
    mw_mesh_point on, on_short;
    float areas[2];
    CHECK(mw_mesh_build(&mesh, vertices, 4, faces, 2, areas, words) == MW_OK && areas[1] == 0.5f);
    mw_mesh_sample(&mesh, uniforms, &on);
    CHECK(on.triangle == 1 && mw_mesh_pdf(&mesh, &on) == 1.0f && on.position[2] == 0.0f);
    CHECK(mw_mesh_init(&mesh, vertices, 4, faces, 2, areas, words) == MW_OK);
    CHECK(mw_mesh_init_trusted(&mesh, vertices, 4, faces, 2, areas, words) == MW_OK);
    CHECK(mw_mesh_u16_build(&short_mesh, vertices, 4, short_faces, 2, areas, words) == MW_OK);
    mw_mesh_u16_sample(&short_mesh, uniforms, &on_short);
    CHECK(memcmp(&on, &on_short, sizeof on) == 0);
    CHECK(mw_mesh_u16_build(&short_mesh, vertices, 4, beyond, 1, areas, words) == MW_OUT_OF_RANGE);
    CHECK(mw_mesh_u16_init(&short_mesh, vertices, 4, beyond, 1, areas, words) != MW_OK);
    CHECK(mw_mesh_u16_init_trusted(&short_mesh, vertices, 4, short_faces, 0, areas, words) != MW_OK);
}

static void counts_are_drawn(void)
{
    mw_geometric coin;
    mw_poisson events;
    mw_poisson_rejection many;
    mw_binomial few;
    mw_binomial_rejection crowd;
    mw_pcg32 rng = seeded(4), same = seeded(4);
    mw_source source = {from_pcg32, &same}, dry = {fails, NULL};
    CHECK(mw_geometric_init(&coin, 0.25f) == MW_OK);
    CHECK(mw_poisson_init_from_ratio(&events, 7, 2) == MW_OK);
    CHECK(mw_poisson_rejection_init(&many, 100.0f) == MW_OK);
    CHECK(mw_binomial_init_from_ratio(&few, 20, 1, 4) == MW_OK);
    CHECK(mw_binomial_rejection_init(&crowd, 1000, 0.75f) == MW_OK);
    for (int i = 0; i < 1000; i++) {
        uint32_t count, tries, other, others;
        CHECK(mw_geometric_draw_from(&coin, &source, &count) == MW_OK && count == mw_geometric_draw(&coin, &rng));
        CHECK(mw_poisson_draw_from(&events, &source, &count) == MW_OK && count == mw_poisson_draw(&events, &rng));
        CHECK(mw_binomial_draw_from(&few, &source, &count) == MW_OK && count == mw_binomial_draw(&few, &rng));
        CHECK(mw_poisson_rejection_draw(&many, &rng, &count, &tries) == MW_OK && tries >= 1);
        CHECK(mw_poisson_rejection_draw_from(&many, &source, &other, &others) == MW_OK);
        CHECK(other == count && others == tries);
        CHECK(mw_binomial_rejection_draw(&crowd, &rng, &count, &tries) == MW_OK && count <= 1000);
        CHECK(mw_binomial_rejection_draw_from(&crowd, &source, &other, NULL) == MW_OK && other == count);
    }
    CHECK(mw_geometric_pmf(&coin, 1) == 0.1875f && mw_geometric_count(&coin, 0) == 0);
    CHECK(mw_poisson_sample(&events, NAN) == 0 && mw_poisson_count(&events, 0) == 0);
    uint32_t count = 77;
    CHECK(mw_geometric_draw_from(&coin, &dry, &count) == MW_SOURCE_FAILED && count == 77);
    CHECK(mw_geometric_init(&coin, 0.0f) != MW_OK && mw_geometric_init(&coin, NAN) == MW_NOT_FINITE);
    CHECK(mw_geometric_init_from_ratio(&coin, 3, 2) != MW_OK);
    CHECK(mw_geometric_init_from_ratio(&coin, 0, 0) != MW_OK);
    CHECK(mw_poisson_init(&events, -1.0f) != MW_OK && mw_poisson_init(&events, INFINITY) != MW_OK);
    CHECK(mw_poisson_init_from_ratio(&events, 1, 0) != MW_OK);
    CHECK(mw_poisson_rejection_init(&many, 1.0f) == MW_OUT_OF_RANGE);
    CHECK(mw_poisson_rejection_set_budget(&many, 0) == MW_NOT_POSITIVE);
    CHECK(mw_poisson_rejection_draw_from(&many, &dry, &count, NULL) == MW_SOURCE_FAILED);
    CHECK(mw_binomial_count(&few, 0) == 0 && mw_binomial_pmf(&few, 21) == 0.0f);
    CHECK(mw_binomial_init(&few, 3, NAN) == MW_NOT_FINITE);
    CHECK(mw_binomial_init(&few, 401, 0.5f) == MW_TOO_LARGE);
    CHECK(mw_binomial_init_from_ratio(&few, 3, 4, 3) == MW_OUT_OF_RANGE);
    CHECK(mw_binomial_init(&few, 9, 1.0f) == MW_OK && mw_binomial_sample(&few, NAN) == 9);
    CHECK(mw_binomial_rejection_init(&crowd, 10, 0.5f) == MW_OUT_OF_RANGE);
    CHECK(mw_geometric_sample(&coin, 0.0f) == 0);
}

/* Numbers, shares, angles and integers: what is drawn from a source is what is drawn. */
static void random_quantities_are_drawn(void)
{
    static const float die[6] = {4.0f, 2.0f, 0.5f, 1.0f, 1.5f, 1.0f}, none[3] = {1.0f, 0.0f, 1.0f};
    static const float eight[8] = {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f};
    mw_gamma wait, few;
    mw_beta share;
    mw_dirichlet_3 three;
    mw_dirichlet_6 six;
    mw_dirichlet_8 many;
    mw_von_mises heading;
    mw_discrete_gaussian peak;
    mw_discrete_laplace tails;
    mw_pcg32 rng = seeded(35), same = seeded(35);
    mw_source source = {from_pcg32, &same}, dry = {fails, NULL};
    CHECK(mw_gamma_init(&wait, 2.5f, 4.0f) == MW_OK);
    CHECK(mw_gamma_init_chi_squared(&few, 0.5f) == MW_OK);
    CHECK(mw_beta_init(&share, 2.0f, 3.0f) == MW_OK);
    CHECK(mw_dirichlet_6_init(&six, die) == MW_OK);
    CHECK(mw_dirichlet_8_init(&many, eight) == MW_OK);
    CHECK(mw_von_mises_init(&heading, 0.0f, 0.0f) == MW_OK);
    CHECK(mw_discrete_gaussian_init(&peak, 0.5f, 3.0f) == MW_OK);
    CHECK(mw_discrete_laplace_init_from_ratio(&tails, 5, 2) == MW_OK);
    for (int i = 0; i < 1000; i++) {
        float x, y, shares[8], others[8];
        int32_t integer;
        uint32_t tries = 0, again;
        CHECK(mw_gamma_draw(&wait, &rng, &x, &tries) == MW_OK && tries >= 1 && x > 0.0f);
        CHECK(mw_gamma_draw_from(&wait, &source, &y, &again) == MW_OK && x == y && tries == again);
        CHECK(mw_gamma_draw_ln(&few, &rng, &x, NULL) == MW_OK);
        CHECK(mw_gamma_draw_ln_from(&few, &source, &y, NULL) == MW_OK && x == y);
        CHECK(mw_beta_draw(&share, &rng, shares, NULL) == MW_OK && mw_beta_pdf(&share, shares) > 0.0f);
        CHECK(mw_beta_draw_from(&share, &source, others, NULL) == MW_OK && shares[0] == others[0]);
        CHECK(mw_dirichlet_6_draw(&six, &rng, shares, &tries) == MW_OK && tries >= 6);
        CHECK(mw_dirichlet_6_draw_from(&six, &source, others, NULL) == MW_OK);
        CHECK(memcmp(shares, others, 6 * sizeof shares[0]) == 0);
        CHECK(mw_dirichlet_8_draw(&many, &rng, shares, NULL) == MW_OK);
        CHECK(mw_dirichlet_8_draw_from(&many, &source, others, NULL) == MW_OK);
        CHECK(memcmp(shares, others, sizeof shares) == 0);
        CHECK(mw_von_mises_draw(&heading, &rng, &x, NULL) == MW_OK);
        CHECK(mw_von_mises_draw_from(&heading, &source, &y, NULL) == MW_OK && x == y);
        CHECK(mw_discrete_gaussian_draw_from(&peak, &source, &integer) == MW_OK);
        CHECK(integer == mw_discrete_gaussian_draw(&peak, &rng));
        CHECK(mw_discrete_laplace_draw_from(&tails, &source, &integer) == MW_OK);
        CHECK(integer == mw_discrete_laplace_draw(&tails, &rng));
    }

    CHECK(mw_gamma_pdf(&wait, -1.0f) == 0.0f && mw_gamma_pdf(&wait, NAN) == 0.0f);
    CHECK(mw_discrete_laplace_sample(&tails, NAN) == -55 && mw_discrete_laplace_integer(&tails, UINT32_MAX) == 55);
    CHECK(mw_discrete_gaussian_sample(&peak, 2.0f) == mw_discrete_gaussian_integer(&peak, 0xffffff00u));
    CHECK(mw_discrete_gaussian_integer(&peak, 0) == 1 - mw_discrete_gaussian_integer(&peak, UINT32_MAX));
    CHECK(mw_discrete_gaussian_pmf(&peak, INT32_MIN) == 0.0f && mw_discrete_gaussian_pmf(&peak, 1) > 0.13f);
    float kept[3] = {7.0f, 7.0f, 7.0f};
    uint32_t tries = 9;
    CHECK(mw_gamma_draw_from(&wait, &dry, kept, &tries) == MW_SOURCE_FAILED && kept[0] == 7.0f && tries == 9);
    CHECK(mw_gamma_set_budget(&wait, 0) == MW_NOT_POSITIVE);
    CHECK(mw_beta_set_budget(&share, 1) == MW_OK);
    CHECK(mw_beta_draw(&share, &rng, kept, &tries) == MW_BUDGET_SPENT && kept[1] == 7.0f && tries == 1);
    CHECK(mw_gamma_init(&wait, 0.0f, 1.0f) == MW_NOT_POSITIVE && mw_gamma_init(&wait, NAN, 1.0f) == MW_NOT_FINITE);
    CHECK(mw_gamma_init(&wait, 2e6f, 1.0f) == MW_OUT_OF_RANGE && mw_gamma_init(&wait, 1.0f, 1e-38f) == MW_EMPTY);
    CHECK(mw_gamma_init(&wait, 1e6f, 1e38f) == MW_TOO_LARGE && mw_gamma_init(&wait, 1.0f, -1.0f) == MW_NOT_POSITIVE);
    CHECK(mw_gamma_init_chi_squared(&wait, INFINITY) == MW_NOT_FINITE);
    CHECK(mw_beta_init(&share, 1.0f, 0.0f) == MW_NOT_POSITIVE && mw_beta_init(&share, 1e-31f, 1.0f) == MW_OUT_OF_RANGE);
    CHECK(mw_dirichlet_3_init(&three, none) == MW_NOT_POSITIVE);
    CHECK(mw_von_mises_init(&heading, 0.0f, -1.0f) == MW_NEGATIVE && mw_von_mises_init(&heading, 7.0f, 1.0f) == MW_OUT_OF_RANGE);
    CHECK(mw_discrete_gaussian_init(&peak, 0.0f, 21.0f) == MW_TOO_LARGE);
    CHECK(mw_discrete_gaussian_init(&peak, 2e9f, 1.0f) == MW_OUT_OF_RANGE);
    CHECK(mw_discrete_laplace_init(&tails, 0.0f) == MW_NOT_POSITIVE && mw_discrete_laplace_init(&tails, 1e8f) == MW_TOO_LARGE);
    CHECK(mw_discrete_laplace_init_from_ratio(&tails, 1, 0) == MW_NOT_POSITIVE);
}

static void resampling_keeps_its_shares(void)
{
    uint32_t integers[ENTRIES], copies[ENTRIES];
    CHECK(mw_resample_to_integers(weights, ENTRIES, integers) == MW_OK);
    mw_pcg32 of_strata = seeded(9);
    for (int way = 0; way < 3; way++) {
        memcpy(copies, integers, sizeof copies);
        mw_error error = way == 0   ? mw_resample_residual(copies, ENTRIES, 80, 12345)
                         : way == 1 ? mw_resample_systematic(copies, ENTRIES, 80, 12345)
                                    : mw_resample_stratified(copies, ENTRIES, 80, &of_strata);
        CHECK(error == MW_OK);
        uint32_t sum = 0;
        for (int i = 0; i < ENTRIES; i++) {
            CHECK(near(copies[i], 10.0 * (double)weights[i], weights[i] > 0.0f ? 2.0 : 0.0));
            sum += copies[i];
        }
        CHECK(sum == 80);
    }
    static const float bad[2] = {1.0f, -1.0f};
    uint32_t zeros[2] = {0, 0};
    CHECK(mw_resample_to_integers(bad, 2, zeros) == MW_NEGATIVE_WEIGHT);
    CHECK(mw_resample_systematic(zeros, 2, 8, 0) == MW_ALL_ZERO);
    CHECK(mw_resample_residual(zeros, 0, 8, 0) == MW_NO_WEIGHTS);
    CHECK(mw_resample_stratified(zeros, 2, 8, &of_strata) == MW_ALL_ZERO);

    mw_reservoir reservoir;
    mw_pcg32 rng = seeded(5);
    bool taken = true;
    uint32_t item = 9;
    mw_reservoir_init(&reservoir);
    CHECK(!mw_reservoir_item(&reservoir, &item) && item == 9);
    for (uint32_t i = 0; i < 3; i++)
        CHECK(mw_reservoir_offer(&reservoir, i, weights[i], &rng, &taken) == MW_OK && (i > 0 || !taken));
    CHECK(mw_reservoir_item(&reservoir, &item) && (item == 1 || item == 2));
    CHECK(mw_reservoir_pmf(&reservoir) == (float)item / 3.0f);
    taken = true;
    CHECK(mw_reservoir_offer(&reservoir, 1, NAN, &rng, &taken) != MW_OK && taken);
}

static bool in_disk(void *context, const float x[2])
{
    ++*(int *)context;
    return x[0] * x[0] + x[1] * x[1] < 1.0f;
}

static bool nowhere(void *context, float x)
{
    (void)context;
    return x > 2.0f;
}

static bool in_ball(void *context, const float x[3])
{
    (void)context;
    return x[0] * x[0] + x[1] * x[1] + x[2] * x[2] < 1.0f;
}

static float twice(void *context, float x)
{
    (void)context;
    return 2.0f * x;
}

static float constant(void *context, const float *x)
{
    (void)x;
    return *(float *)context;
}

static void rejection_ends(void)
{
    mw_pcg32 rng = seeded(6), same = seeded(6);
    mw_source source = {from_pcg32, &same}, dry = {fails, NULL};
    mw_ziggurat_standard_normal a;
    mw_ziggurat_normal b;
    mw_ziggurat_standard_exponential c;
    mw_ziggurat_exponential d;
    CHECK(mw_ziggurat_standard_normal_init(&a) == MW_OK && mw_ziggurat_normal_init(&b, 5, 2) == MW_OK);
    CHECK(mw_ziggurat_standard_exponential_init(&c) == MW_OK);
    CHECK(mw_ziggurat_exponential_init(&d, 0.25f) == MW_OK);
    CHECK(mw_ziggurat_exponential_init_from_mean(&d, 4.0f) == MW_OK);
    for (int i = 0; i < 1000; i++) {
        float x, y;
        CHECK(mw_ziggurat_standard_normal_draw(&a, &rng, &x, NULL) == MW_OK);
        CHECK(mw_ziggurat_standard_normal_draw_from(&a, &source, &y, NULL) == MW_OK && x == y);
        CHECK(mw_ziggurat_normal_draw(&b, &rng, &x, NULL) == MW_OK);
        CHECK(mw_ziggurat_normal_draw_from(&b, &source, &y, NULL) == MW_OK && x == y);
        CHECK(mw_ziggurat_standard_exponential_draw(&c, &rng, &x, NULL) == MW_OK && x > 0.0f);
        CHECK(mw_ziggurat_exponential_draw(&d, &rng, &y, NULL) == MW_OK && y > 0.0f);
        CHECK(mw_ziggurat_standard_exponential_draw_from(&c, &source, &y, NULL) == MW_OK && x == y);
        CHECK(mw_ziggurat_exponential_draw_from(&d, &source, &y, NULL) == MW_OK);
    }
    float x = 77.0f;
    CHECK(mw_ziggurat_normal_init(&b, 0.0f, -1.0f) == MW_NOT_POSITIVE);
    CHECK(mw_ziggurat_exponential_init(&d, NAN) == MW_NOT_FINITE);
    CHECK(mw_ziggurat_exponential_init_from_mean(&d, 0.0f) == MW_NOT_POSITIVE);
    CHECK(mw_ziggurat_normal_set_budget(&b, 0) == MW_NOT_POSITIVE);
    CHECK(mw_ziggurat_exponential_set_budget(&d, 9) == MW_OK);
    CHECK(mw_ziggurat_standard_normal_draw_from(&a, &dry, &x, NULL) == MW_SOURCE_FAILED && x == 77.0f);

    mw_disk_rejection disk;
    mw_ball_rejection ball;
    mw_fixed_disk_rejection fixed;
    mw_fixed_disk_rejection_16 fixed_16;
    float point[3];
    int32_t words[2];
    CHECK(mw_disk_rejection_init(&disk) == MW_OK && mw_ball_rejection_init(&ball) == MW_OK);
    CHECK(mw_fixed_disk_rejection_init(&fixed) == MW_OK);
    CHECK(mw_fixed_disk_rejection_16_init(&fixed_16) == MW_OK);
    for (int i = 0; i < 1000; i++) {
        CHECK(mw_disk_rejection_draw(&disk, &rng, point, NULL) == MW_OK);
        CHECK(point[0] * point[0] + point[1] * point[1] <= 1.0f);
        CHECK(mw_ball_rejection_draw(&ball, &rng, point, NULL) == MW_OK && in_ball(NULL, point));
        CHECK(mw_fixed_disk_rejection_draw(&fixed, &rng, words, NULL) == MW_OK);
        CHECK((double)words[0] * words[0] + (double)words[1] * words[1] <= ldexp(1.0, 60));
        CHECK(mw_fixed_disk_rejection_16_draw_from(&fixed_16, &source, words, NULL) == MW_OK);
        CHECK((double)words[0] * words[0] + (double)words[1] * words[1] <= ldexp(1.0, 60));
    }

    int calls = 0;
    uint32_t tries = 0, budget;
    mw_aabb_2d square;
    mw_aabb_3d cube;
    mw_interval line;
    static const float low[3] = {-1, -1, -1}, high[3] = {1, 1, 1};
    CHECK(mw_aabb_2d_init(&square, low, high) == MW_OK && mw_aabb_3d_init(&cube, low, high) == MW_OK);
    CHECK(mw_interval_init(&line, 0.0f, 1.0f) == MW_OK);
    mw_region_2d region = {in_disk, &calls};
    CHECK(mw_region_2d_draw(&square, &region, 100, &rng, point, &tries) == MW_OK);
    CHECK(calls == (int)tries && in_disk(&calls, point));
    mw_region_3d round = {in_ball, NULL};
    CHECK(mw_region_3d_draw(&cube, &round, 100, &rng, point, NULL) == MW_OK && in_ball(NULL, point));
    mw_region_1d none = {nowhere, NULL};
    CHECK(mw_region_1d_draw(&line, &none, 10, &rng, &x, &tries) == MW_BUDGET_SPENT && tries == 10);
    CHECK(mw_region_1d_draw(&line, &none, 0, &rng, &x, &tries) == MW_NOT_POSITIVE && x == 77.0f);
    mw_density_1d ramp = {twice, NULL};
    mw_moments sum = {0};
    for (int i = 0; i < 20000; i++) {
        CHECK(mw_bounded_1d_draw(&line, &ramp, 2.0f, 200, &rng, &x, NULL) == MW_OK);
        mw_moments_push(&sum, x);
    }
    CHECK(mw_moments_mean(&sum, &x) && near((double)x, 2.0 / 3.0, 0.01));
    static const struct {
        float density;
        mw_error error;
    } bad[] = {{NAN, MW_BAD_DENSITY}, {-1.0f, MW_BAD_DENSITY}, {1.0f, MW_BOUND_EXCEEDED}};
    for (size_t i = 0; i < 3; i++) {
        float density = bad[i].density;
        mw_density_2d of_2 = {constant, &density};
        mw_density_3d of_3 = {constant, &density};
        CHECK(mw_bounded_2d_draw(&square, &of_2, 1.0f, 9, &rng, point, NULL) == bad[i].error);
        CHECK(mw_bounded_3d_draw(&cube, &of_3, 1.0f, 9, &rng, point, NULL) == bad[i].error);
        CHECK(mw_bounded_2d_draw(&square, &of_2, NAN, 9, &rng, point, NULL) == MW_NOT_FINITE);
    }
    CHECK(mw_budget_for(0.5f, &budget) == MW_OK && budget > 10 && budget < 100);
    CHECK(mw_budget_for(NAN, &budget) == MW_NOT_FINITE);
}

static void estimators_estimate(void)
{
    mw_moments all, half;
    mw_weighted_mean weighted;
    mw_integral integral;
    float x = 77.0f;
    mw_moments_init(&all);
    mw_moments_init(&half);
    CHECK(!mw_moments_mean(&all, &x) && !mw_moments_variance(&all, &x) && x == 77.0f);
    for (int i = 0; i < 4; i++)
        mw_moments_push(i < 2 ? &all : &half, (float)i);
    mw_moments_push(&half, NAN);
    mw_moments_merge(&all, &half);
    CHECK(mw_moments_count(&all) == 4 && mw_moments_refused(&all) == 1);
    CHECK(mw_moments_mean(&all, &x) && x == 1.5f);
    CHECK(mw_moments_population_variance(&all, &x) && x == 1.25f);
    CHECK(mw_moments_std_dev(&all, &x) && near((double)x, sqrt(5.0 / 3.0), 1e-6));
    mw_moments_merge(&all, &all);
    CHECK(mw_moments_count(&all) == 8);
    mw_weighted_mean_init(&weighted);
    CHECK(!mw_weighted_mean_mean(&weighted, &x));
    mw_weighted_mean_push(&weighted, 1.0f, 3.0f);
    mw_weighted_mean_push(&weighted, 5.0f, 1.0f);
    mw_weighted_mean_push(&weighted, INFINITY, 1.0f);
    CHECK(mw_weighted_mean_mean(&weighted, &x) && x == 2.0f);
    CHECK(mw_weighted_mean_standard_error(&weighted, &x) && x > 0.0f);
    mw_weighted_mean_merge(&weighted, &weighted);
    CHECK(mw_weighted_mean_count(&weighted) == 4 && mw_weighted_mean_refused(&weighted) == 2);
    mw_integral_init(&integral);
    CHECK(!mw_integral_estimate(&integral, &x));
    mw_integral_push(&integral, 1.0f, 0.5f);
    mw_integral_push(&integral, 1.0f, 0.25f);
    mw_integral_push(&integral, 1.0f, 0.0f);
    CHECK(mw_integral_estimate(&integral, &x) && x == 3.0f && mw_integral_refused(&integral) == 1);
    CHECK(mw_integral_standard_error(&integral, &x) && near((double)x, 1.0, 1e-6));
    mw_integral_merge(&integral, &integral);
    CHECK(mw_integral_count(&integral) == 4);
    CHECK(mw_balance_heuristic(1, 1.0f, 1, 3.0f) == 0.25f);
    CHECK(mw_power_heuristic(1, 1.0f, 1, 3.0f) == 0.1f);
    CHECK(mw_balance_heuristic(1, 0.0f, 1, 0.0f) == 0.0f);
    const uint32_t counts[3] = {1, 1, 2};
    const float densities[3] = {3.0f, 1.0f, 2.0f};
    CHECK(mw_balance_heuristic_of(counts, densities, 3, 2) == 0.5f);
    CHECK(mw_power_heuristic_of(counts, densities, 2, 0) == 0.9f);
    CHECK(mw_balance_heuristic_of(counts, densities, 3, 3) == 0.0f);
    CHECK(mw_balance_heuristic_of(NULL, NULL, 0, 0) == 0.0f);
    CHECK(mw_roulette(0.25f, 0x3fffffffu, &x) && x == 4.0f);
    CHECK(!mw_roulette(0.25f, 0x40000000u, &x) && !mw_roulette(NAN, 0, &x) && x == 4.0f);
}

/* A normal density around 1, up to a factor, of as many coordinates as the context says. */
static float bell(void *context, const float *x)
{
    float sum = 0.0f;
    for (int i = 0; i < *(int *)context; i++)
        sum += (x[i] - 1.0f) * (x[i] - 1.0f);
    return expf(-0.5f * sum);
}

static float bell_1d(void *context, float x)
{
    (void)context;
    return expf(-0.5f * (x - 1.0f) * (x - 1.0f));
}

static float not_a_density(void *context, const float *x)
{
    (void)context;
    return x[0] == 0.5f ? 1.0f : NAN;
}

#define A_CHAIN(D)                                                                              \
    static void chain_##D##d(void)                                                              \
    {                                                                                           \
        int coordinates = D;                                                                    \
        mw_density_##D##d target = {bell, &coordinates}, worse = {not_a_density, NULL};          \
        float start[D], widths[D], bad[D];                                                      \
        for (int i = 0; i < D; i++) {                                                           \
            start[i] = 0.5f;                                                                    \
            widths[i] = 1.0f;                                                                   \
            bad[i] = -1.0f;                                                                     \
        }                                                                                       \
        mw_chain_##D##d chain, before;                                                          \
        mw_transition_##D##d step;                                                              \
        mw_pcg32 rng = seeded(D);                                                               \
        mw_source source = {from_pcg32, &rng}, dry = {fails, NULL};                             \
        CHECK(mw_chain_##D##d_init(&chain, start, &target) == MW_OK);                           \
        mw_moments sums;                                                                        \
        mw_moments_init(&sums);                                                                 \
        for (int i = 0; i < 40000; i++) {                                                       \
            CHECK(mw_chain_##D##d_step_normal(&chain, widths, &target, &rng, &step) == MW_OK);  \
            CHECK(step.outcome != MW_ACCEPTED || chain.density == step.proposed_density);       \
            CHECK(mw_chain_##D##d_step_box_from(&chain, widths, &target, &source, NULL) == MW_OK); \
            mw_moments_push(&sums, chain.state[D - 1]);                                         \
        }                                                                                       \
        float mean;                                                                             \
        CHECK(mw_moments_mean(&sums, &mean) && near((double)mean, 1.0, 0.1));                   \
        CHECK(chain.steps == 80000 && chain.accepted > 4000);                                   \
        before = chain;                                                                         \
        CHECK(mw_chain_##D##d_step_normal(&chain, bad, &target, &rng, NULL) != MW_OK);          \
        CHECK(mw_chain_##D##d_step_box(&chain, bad, &target, &rng, NULL) != MW_OK);             \
        CHECK(mw_chain_##D##d_step_normal_from(&chain, widths, &target, &dry, NULL) ==          \
              MW_SOURCE_FAILED);                                                                \
        CHECK(memcmp(&chain, &before, sizeof chain) == 0);                                      \
        CHECK(mw_chain_##D##d_init(&chain, bad, &worse) == MW_NOT_FINITE);                      \
        CHECK(memcmp(&chain, &before, sizeof chain) == 0);                                      \
        CHECK(mw_chain_##D##d_init(&chain, start, &worse) == MW_OK);                            \
        CHECK(mw_chain_##D##d_step_uniform(&chain, &worse, &rng, &step) == MW_OK);              \
        CHECK(step.outcome == MW_REFUSED && chain.refused == 1 && chain.state[0] == 0.5f);      \
        CHECK(mw_chain_##D##d_step_to(&chain, bad, 1, 1, &target, &rng, &step) == MW_OK);       \
        CHECK(step.proposed[0] == -1.0f);                                                       \
        CHECK(mw_chain_##D##d_step_to_from(&chain, bad, 0, 1, &target, &source, &step) == MW_OK); \
        CHECK(step.outcome == MW_REFUSED);                                                      \
        CHECK(mw_chain_##D##d_step_uniform_from(&chain, &target, &source, &step) == MW_OK);     \
        CHECK(mw_chain_##D##d_init(&chain, start, &target) == MW_OK);                           \
        for (int i = 0; i < 100; i++) {                                                         \
            CHECK(mw_chain_##D##d_step_wrapped(&chain, widths, &target, &rng, NULL) == MW_OK);  \
            CHECK(mw_chain_##D##d_step_wrapped_from(&chain, widths, &target, &source, NULL) == MW_OK); \
            CHECK(chain.state[0] >= 0.0f && chain.state[0] < 1.0f);                             \
        }                                                                                       \
        chain.accepted = chain.steps + 1;                                                       \
        CHECK(mw_chain_##D##d_step_uniform(&chain, &target, &rng, NULL) == MW_OUT_OF_RANGE);    \
    }

A_CHAIN(2)
A_CHAIN(3)
A_CHAIN(4)
A_CHAIN(6)
A_CHAIN(8)

static void chain_1d(void)
{
    mw_chain_1d chain;
    mw_density_1d target = {bell_1d, NULL};
    mw_pcg32 rng = seeded(7);
    mw_moments sums;
    mw_moments_init(&sums);
    CHECK(mw_chain_1d_init(&chain, 0.0f, &target) == MW_OK);
    for (int i = 0; i < 40000; i++) {
        CHECK(mw_chain_1d_step_normal(&chain, 2.0f, &target, &rng, NULL) == MW_OK);
        mw_moments_push(&sums, chain.state);
    }
    float x;
    CHECK(mw_moments_mean(&sums, &x) && near((double)x, 1.0, 0.1));
    CHECK(mw_moments_variance(&sums, &x) && near((double)x, 1.0, 0.1));
    CHECK(mw_chain_1d_init(&chain, NAN, &target) == MW_NOT_FINITE);
}

/* Logarithms of what bell says, and of nothing. */
static float log_bell(void *context, const float *x)
{
    float sum = 0.0f;
    for (int i = 0; i < *(int *)context; i++)
        sum += (x[i] - 1.0f) * (x[i] - 1.0f);
    return -0.5f * sum;
}

static float log_bell_1d(void *context, float x)
{
    int one = 1;
    (void)context;
    return log_bell(&one, &x);
}

static float only_here(void *context, const float *x)
{
    return x[0] == 0.5f ? 0.0f : *(const float *)context;
}

#define A_LOG_CHAIN(D)                                                                          \
    static void log_chain_##D##d(void)                                                          \
    {                                                                                           \
        int coordinates = D;                                                                    \
        float elsewhere = -INFINITY;                                                            \
        mw_density_##D##d target = {log_bell, &coordinates}, hard = {only_here, &elsewhere};    \
        float start[D], widths[D];                                                              \
        for (int i = 0; i < D; i++) {                                                           \
            start[i] = 0.5f;                                                                    \
            widths[i] = 1.0f;                                                                   \
        }                                                                                       \
        mw_log_chain_##D##d chain = {0}, before = {0};                                          \
        mw_transition_##D##d step;                                                              \
        mw_pcg32 rng = seeded(D);                                                               \
        mw_source source = {from_pcg32, &rng};                                                  \
        CHECK(mw_log_chain_##D##d_step_uniform(&chain, &target, &rng, NULL) == MW_NOT_POSITIVE); \
        CHECK(memcmp(&chain, &before, sizeof chain) == 0);                                      \
        CHECK(mw_log_chain_##D##d_init(&chain, start, &target) == MW_OK);                       \
        mw_moments sums = {0};                                                                  \
        for (int i = 0; i < 40000; i++) {                                                       \
            CHECK(mw_log_chain_##D##d_step_normal(&chain, widths, &target, &rng, &step) == MW_OK); \
            CHECK(step.outcome != MW_ACCEPTED || chain.density == step.proposed_density);       \
            CHECK(mw_log_chain_##D##d_step_box_from(&chain, widths, &target, &source, NULL) == MW_OK); \
            mw_moments_push(&sums, chain.state[D - 1]);                                         \
        }                                                                                       \
        float mean;                                                                             \
        CHECK(mw_moments_mean(&sums, &mean) && near((double)mean, 1.0, 0.1));                   \
        CHECK(chain.steps == 80000 && chain.accepted > 4000);                                   \
        CHECK(mw_log_chain_##D##d_init(&chain, start, &hard) == MW_OK);                         \
        CHECK(mw_log_chain_##D##d_step_uniform(&chain, &hard, &rng, &step) == MW_OK);           \
        CHECK(step.outcome == MW_REJECTED && step.acceptance == 0.0f && chain.refused == 0);    \
        elsewhere = INFINITY;                                                                   \
        CHECK(mw_log_chain_##D##d_step_wrapped(&chain, widths, &hard, &rng, &step) == MW_OK);   \
        CHECK(step.outcome == MW_REFUSED && chain.refused == 1 && chain.state[0] == 0.5f);      \
        elsewhere = NAN;                                                                        \
        CHECK(mw_log_chain_##D##d_step_to(&chain, widths, 1, 1, &hard, &rng, &step) == MW_OK);  \
        CHECK(step.outcome == MW_REFUSED && chain.refused == 2);                                \
        before = chain;                                                                         \
        CHECK(mw_log_chain_##D##d_init(&chain, widths, &hard) == MW_NOT_FINITE);                \
        elsewhere = -INFINITY;                                                                  \
        CHECK(mw_log_chain_##D##d_init(&chain, widths, &hard) == MW_NOT_POSITIVE);              \
        CHECK(memcmp(&chain, &before, sizeof chain) == 0);                                      \
    }

A_LOG_CHAIN(2)
A_LOG_CHAIN(3)
A_LOG_CHAIN(4)
A_LOG_CHAIN(6)
A_LOG_CHAIN(8)

static void log_chain_1d(void)
{
    mw_log_chain_1d chain = {0};
    mw_density_1d target = {log_bell_1d, NULL};
    mw_pcg32 rng = seeded(7);
    mw_moments sums = {0};
    CHECK(mw_log_chain_1d_step_normal(&chain, 2.0f, &target, &rng, NULL) == MW_NOT_POSITIVE);
    CHECK(mw_log_chain_1d_init(&chain, 40.0f, &target) == MW_OK && chain.density < -700.0f);
    for (int i = 0; i < 40000; i++) {
        CHECK(mw_log_chain_1d_step_normal(&chain, 2.0f, &target, &rng, NULL) == MW_OK);
        if (i > 100)
            mw_moments_push(&sums, chain.state);
    }
    float x;
    CHECK(mw_moments_mean(&sums, &x) && near((double)x, 1.0, 0.1));
    CHECK(mw_moments_variance(&sums, &x) && near((double)x, 1.0, 0.1));
}

/* The regression of tests/metropolis/logarithms.rs: its 1,000 observations, and its words. */
struct observations {
    float z[1000], y[1000];
};

static float likelihood(void *context, const float x[2])
{
    const struct observations *of = context;
    float sum = 0.0f;
    for (int i = 0; i < 1000; i++) {
        float rest = of->y[i] - x[0] - x[1] * of->z[i];
        sum += rest * rest;
    }
    return -8.0f * sum;
}

static float plainly(void *context, const float x[2])
{
    return expf(likelihood(context, x));
}

static void observations_do_not_underflow(void)
{
    static struct observations observed;
    mw_pcg32 noise, rng;
    mw_pcg32_init(&noise, 7, 0);
    for (int i = 0; i < 1000; i++) {
        observed.z[i] = (float)i / 1000.0f;
        float off = (float)(mw_pcg32_next(&noise) >> 8) / 16777216.0f - 0.5f;
        observed.y[i] = 1.0f + 2.0f * observed.z[i] + off;
    }
    mw_density_2d target = {likelihood, &observed}, underflows = {plainly, &observed};
    static const float start[2] = {0.0f, 0.0f}, std_devs[2] = {0.05f, 0.08f};
    mw_chain_2d plain;
    CHECK(mw_chain_2d_init(&plain, start, &underflows) == MW_NOT_POSITIVE);
    mw_log_chain_2d chain;
    mw_transition_2d step;
    uint32_t hash = 2166136261u;
    mw_pcg32_init(&rng, 42, 54);
    CHECK(mw_log_chain_2d_init(&chain, start, &target) == MW_OK && chain.density < -30000.0f);
    for (int i = 0; i < 2000; i++) {
        CHECK(mw_log_chain_2d_step_normal(&chain, std_devs, &target, &rng, &step) == MW_OK);
        hash = (hash ^ bits_of(step.acceptance)) * 16777619u;
        hash = (hash ^ bits_of(chain.state[0])) * 16777619u;
        hash = (hash ^ bits_of(chain.state[1])) * 16777619u;
    }
    CHECK(hash == 175079190u && chain.accepted == 210);
}

/* A struct of zeros that no init has made: as good as new, or refused. */
static void zeros_are_sound(void)
{
    float x = 77.0f, y = 77.0f, u[8];
    mw_pcg32 rng = {0}, other = {0};
    mw_moments sums = {0}, made;
    mw_moments_init(&made);
    CHECK(!mw_moments_mean(&sums, &x) && mw_moments_count(&sums) == 0 && x == 77.0f);
    mw_moments_push(&sums, NAN);
    mw_moments_push(&made, NAN);
    for (int i = 0; i < 5; i++) {
        mw_moments_push(&sums, 1.0f + (float)i);
        mw_moments_push(&made, 1.0f + (float)i);
    }
    CHECK(mw_moments_mean(&sums, &x) && x == 3.0f && mw_moments_refused(&sums) == 1);
    CHECK(memcmp(&sums, &made, sizeof sums) == 0);
    mw_moments zeros = {0};
    mw_moments_merge(&sums, &zeros);
    CHECK(memcmp(&sums, &made, sizeof sums) == 0);
    mw_moments_merge(&zeros, &sums);
    CHECK(mw_moments_mean(&zeros, &x) && x == 3.0f);
    mw_moments none = {0}, empty = {0};
    mw_moments_merge(&none, &empty);
    mw_moments_push(&none, 5.0f);
    CHECK(mw_moments_mean(&none, &x) && x == 5.0f);

    mw_weighted_mean weighted = {0}, no_weights = {0};
    CHECK(!mw_weighted_mean_mean(&weighted, &x));
    mw_weighted_mean_merge(&weighted, &no_weights);
    mw_weighted_mean_push(&weighted, 1.0f, 3.0f);
    mw_weighted_mean_push(&weighted, 5.0f, 1.0f);
    CHECK(mw_weighted_mean_mean(&weighted, &x) && x == 2.0f);
    mw_integral integral = {0};
    CHECK(!mw_integral_estimate(&integral, &x));
    mw_integral_push(&integral, 1.0f, 0.5f);
    mw_integral_push(&integral, 1.0f, 0.25f);
    CHECK(mw_integral_estimate(&integral, &x) && x == 3.0f);

    uint32_t item = 77, first = mw_pcg32_next(&rng);
    mw_moments_init(&sums);
    for (int i = 0; i < 10000; i++)
        mw_moments_push(&sums, ldexpf((float)(mw_pcg32_next(&rng) >> 8), -24));
    CHECK(mw_moments_mean(&sums, &x) && near((double)x, 0.5, 0.02));
    CHECK(mw_moments_variance(&sums, &x) && near((double)x, 1.0 / 12.0, 0.005));
    CHECK(mw_pcg32_next(&other) == first);

    mw_source source = {0};
    mw_normal normal;
    CHECK(mw_normal_init(&normal, 0.0f, 1.0f) == MW_OK);
    CHECK(mw_normal_draw_from(&normal, &source, &y) == MW_SOURCE_FAILED && y == 77.0f);

    mw_reservoir reservoir = {0};
    bool taken = false;
    CHECK(!mw_reservoir_item(&reservoir, &item) && mw_reservoir_pmf(&reservoir) == 0.0f);
    CHECK(mw_reservoir_offer(&reservoir, 5, 2.0f, &rng, &taken) == MW_OK && taken);
    CHECK(mw_reservoir_item(&reservoir, &item) && item == 5 && mw_reservoir_pmf(&reservoir) == 1.0f);

    mw_light_reservoir lights = {0}, others = {0};
    CHECK(!mw_light_reservoir_item(&lights, &item) && mw_light_reservoir_count(&lights) == 0);
    CHECK(mw_light_reservoir_offer(&lights, 6, 0.0f, 0.5f, &rng, &taken) == MW_OK && !taken);
    CHECK(mw_light_reservoir_offer(&lights, 7, 3.0f, 0.5f, &rng, &taken) == MW_OK && taken);
    CHECK(mw_light_reservoir_item(&lights, &item) && item == 7);
    CHECK(mw_light_reservoir_contribution(&lights) == 1.0f);
    CHECK(mw_light_reservoir_target(&lights) == 3.0f && mw_light_reservoir_count(&lights) == 2);
    CHECK(mw_light_reservoir_offer(&lights, 8, 1.0f, 0.0f, &rng, &taken) == MW_NOT_POSITIVE);
    CHECK(mw_light_reservoir_absorb(&others, &lights, 1.5f, &rng, &taken) == MW_OK && taken);
    CHECK(mw_light_reservoir_contribution(&others) == 1.0f);
    mw_light_reservoir_normalise(&others, 1);
    CHECK(mw_light_reservoir_contribution(&others) == 2.0f);
    mw_light_reservoir_cap(&others, 1);
    CHECK(mw_light_reservoir_contribution(&others) == 2.0f && mw_light_reservoir_count(&others) == 1);
    mw_light_reservoir_init(&others);
    CHECK(!mw_light_reservoir_item(&others, &item));
    CHECK(mw_light_reservoir_offer_from(&others, 9, 1.0f, 1.0f, &source, &taken) == MW_SOURCE_FAILED);

    int coordinates = 2;
    mw_density_2d target = {bell, &coordinates};
    mw_chain_2d chain = {0}, before = {0};
    CHECK(mw_chain_2d_step_uniform(&chain, &target, &rng, NULL) == MW_NOT_POSITIVE);
    CHECK(memcmp(&chain, &before, sizeof chain) == 0);

    mw_sobol_8d points = {{0}};
    mw_recurrence_3d recurrence = {{0}};
    mw_strata_1d line = {{0}};
    mw_strata_2d square = {{0}};
    for (uint32_t i = 0; i < 100; i++) {
        mw_sobol_8d_point(&points, i, u);
        mw_recurrence_3d_point(&recurrence, i, u + 5);
        for (int j = 0; j < 8; j++)
            CHECK(u[j] >= 0.0f && u[j] < 1.0f);
        x = mw_strata_1d_point(&line, i, 0.5f);
        mw_strata_2d_point(&square, i, u, u + 2);
        CHECK(x >= 0.0f && x < 1.0f && u[2] >= 0.0f && u[2] < 1.0f && u[3] >= 0.0f && u[3] < 1.0f);
    }
}

/* Items of an odd size. */
struct card {
    uint8_t number, copy, other;
};

static void orders_are_whole(void)
{
    struct card cards[52];
    bool seen[52] = {false};
    mw_pcg32 rng;
    mw_source failing = {0};
    mw_pcg32_init(&rng, 42, 54);
    for (int i = 0; i < 52; i++) {
        cards[i].number = cards[i].copy = (uint8_t)i;
        cards[i].other = (uint8_t)(51 - i);
    }
    mw_shuffle(cards, 52, sizeof cards[0], &rng);
    CHECK(mw_choose(cards, 52, sizeof cards[0], 51, &rng) == MW_OK);
    for (int i = 0; i < 52; i++) {
        const struct card card = cards[i];
        CHECK(!seen[card.number] && card.copy == card.number && card.other == 51 - card.number);
        seen[card.number] = true;
    }
    const mw_pcg32 before = rng;
    CHECK(mw_choose(cards, 52, sizeof cards[0], 53, &rng) == MW_OUT_OF_RANGE);
    mw_shuffle(NULL, 0, 4, &rng);
    CHECK(mw_choose(NULL, 0, 4, 0, &rng) == MW_OK && memcmp(&rng, &before, sizeof rng) == 0);
    CHECK(mw_shuffle_from(cards, 52, sizeof cards[0], &failing) == MW_SOURCE_FAILED);
    CHECK(mw_choose_from(cards, 52, sizeof cards[0], 1, &failing) == MW_SOURCE_FAILED);
    CHECK(mw_choose_from(cards, 52, sizeof cards[0], 53, &failing) == MW_OUT_OF_RANGE);

    mw_permutation order = {{0}};
    mw_choice_in_order in_order = {{0}};
    mw_choice_of_stream of_stream = {{0}};
    mw_latin_hypercube cube = {{0}};
    uint32_t number = 77, place = 77;
    CHECK(mw_permutation_get(&order, 0, &number) == MW_OUT_OF_RANGE && number == 77);
    CHECK(!mw_choice_in_order_draw(&in_order, &rng));
    CHECK(!mw_choice_of_stream_draw(&of_stream, &rng, &place) && place == 77);
    CHECK(mw_latin_hypercube_word(&cube, 1, 0) != mw_latin_hypercube_word(&cube, 2, 0));
    CHECK(mw_permutation_init(&order, 0, 7) == MW_EMPTY);
    CHECK(mw_choice_in_order_init(&in_order, 4, 3) == MW_OUT_OF_RANGE);
    CHECK(mw_choice_of_stream_init(&of_stream, 0) == MW_EMPTY);
    CHECK(mw_latin_hypercube_init(&cube, 0, 7) == MW_EMPTY);
    CHECK(mw_permutation_init(&order, 9, 7) == MW_OK);
    CHECK(mw_permutation_get(&order, 9, &number) == MW_OUT_OF_RANGE && number == 77);
    CHECK(mw_permutation_index_of(&order, 9, &place) == MW_OUT_OF_RANGE && place == 77);

    mw_screen screen;
    CHECK(mw_screen_init(&screen, 0, 8, 2, 7) == MW_EMPTY);
    CHECK(mw_screen_init(&screen, 65536, 1, 1, 7) == MW_TOO_LARGE);
}

/* What points and words have in common; their bits are golden. */
#define A_SET(SET, D)                                                                           \
    do {                                                                                        \
        mw_##SET set;                                                                           \
        float u[D];                                                                             \
        uint32_t words[D];                                                                      \
        CHECK(mw_##SET##_init(&set, 7) == MW_OK);                                               \
        for (uint32_t i = 0; i < 64; i++) {                                                     \
            mw_##SET##_point(&set, i, u);                                                       \
            mw_##SET##_words(&set, i, words);                                                   \
            for (int k = 0; k < D; k++)                                                         \
                CHECK(near((double)u[k], words[k] / 4294967296.0, 1e-6) && u[k] < 1.0f);        \
        }                                                                                       \
    } while (0)

static void points_cover(void)
{
    mw_strata_1d line;
    mw_strata_2d square;
    A_SET(sobol_1d, 1);
    A_SET(sobol_2d, 2);
    A_SET(sobol_3d, 3);
    A_SET(sobol_4d, 4);
    A_SET(sobol_8d, 8);
    A_SET(recurrence_1d, 1);
    A_SET(recurrence_2d, 2);
    A_SET(recurrence_3d, 3);
    /* As in Rust and in JavaScript: tests/uniforms/points/neighbours.rs. */
    static const uint32_t indices[3] = {0, 1, UINT32_MAX};
    static const uint32_t known[3][3] = {{0x93d8a563, 0xb22cb017, 0x9f114892},
        {0x998a9383, 0xc04268ab, 0x7b4f30ef}, {0xa765a3a5, 0xe9718413, 0xce781d5f}};
    for (int i = 0; i < 3; i++) {
        mw_pcg32 rng;
        mw_pcg32_init_at(&rng, 42, indices[i]);
        for (int k = 0; k < 3; k++)
            CHECK(mw_pcg32_next(&rng) == known[i][k]);
    }
    CHECK(mw_word_by_position(42, 1, 0, 0) != mw_word_by_position(42, 1, 0, 1));
    CHECK(mw_strata_1d_init(&line, 0) != MW_OK);
    CHECK(mw_strata_2d_init(&square, 0, 2) != MW_OK && mw_strata_2d_init(&square, 1, 0) != MW_OK);
}

/* A lobe about a normal: turned back, a direction has the density that it was sampled with. */
static void frames_turn(void)
{
    static const float up[3] = {0, 0, 1}, zero[3] = {0, 0, 0}, bad[3] = {0, NAN, 0};
    float normal[3] = {0, -3, 4}, u[2] = {0.25f, 0.75f}, local[3], world[3];
    mw_frame frame, before;
    mw_phong_lobe lobe;
    CHECK(mw_frame_init(&frame, normal) == MW_OK && mw_phong_lobe_init(&lobe, 50.0f) == MW_OK);
    mw_frame_to_world(&frame, up, world);
    CHECK(near((double)world[1], -0.6, 1e-6) && near((double)world[2], 0.8, 1e-6));
    float density = mw_phong_lobe_sample_with_pdf(&lobe, u, local);
    mw_frame_to_world(&frame, local, world);
    CHECK(near((double)(world[2] * 0.8f - world[1] * 0.6f), (double)local[2], 1e-6));
    mw_frame_to_local(&frame, world, world); /* in place */
    CHECK(near((double)mw_phong_lobe_pdf(&lobe, world), (double)density, 1e-4 * (double)density));
    before = frame;
    CHECK(mw_frame_init(&frame, zero) == MW_ZERO_LENGTH && mw_frame_init(&frame, bad) == MW_NOT_FINITE);
    CHECK(memcmp(&frame, &before, sizeof frame) == 0);
}

/* Lamps and gloss at ends: uniforms that are none, directions below the surface, a source that fails. */
static void lamps_are_total(void)
{
    static const float here[3] = {0, 0, 0}, centre[3] = {0, 0, 2}, bad[2] = {NAN, INFINITY}, down[3] = {0, 0, -1};
    static const float level[3] = {1, 0, 0}, alpha[2] = {0.5f, 0.5f}, nothing[3] = {NAN, NAN, NAN};
    const mw_source dry = {fails, NULL};
    mw_visible_sphere ball;
    mw_ggx_visible gloss;
    mw_ggx surface;
    mw_light_sample to, kept;
    mw_reflection bounce;
    CHECK(mw_visible_sphere_init(&ball, here, centre, 1.0f) == MW_OK);
    mw_visible_sphere_sample_light(&ball, bad, &to);
    CHECK(to.distance >= 1.0f && to.distance <= 1.7321f && to.pdf == mw_visible_sphere_density(&ball));
    CHECK(near((double)to.pdf, 1.0 / (6.283185307 * (1.0 - 0.8660254038)), 1e-5) && to.place[0] == 0.0f);
    kept = to;
    CHECK(mw_visible_sphere_draw_light_from(&ball, &dry, &to) == MW_SOURCE_FAILED);
    CHECK(memcmp(&kept, &to, sizeof to) == 0);
    CHECK(mw_ggx_visible_init(&gloss, level, alpha) == MW_OK && mw_ggx_init(&surface, alpha) == MW_OK);
    mw_ggx_visible_reflect(&gloss, bad, &bounce);
    CHECK(bounce.pdf > 0.0f && isfinite(bounce.pdf) && isfinite(bounce.direction[2]));
    CHECK(mw_ggx_visible_g1(&gloss) == 0.0f && mw_ggx_visible_unmasked(&gloss, down) == 0.0f);
    CHECK(mw_ggx_visible_visibility(&gloss, down) == 0.0f && mw_ggx_distribution(&surface, down) == 0.0f);
    CHECK(mw_ggx_visible_visibility(&gloss, nothing) == 0.0f && mw_ggx_distribution(&surface, nothing) == 0.0f);
    CHECK(mw_ggx_g1(&surface, down) == 0.0f && mw_ggx_g1(&surface, nothing) == 0.0f);
    CHECK(mw_ggx_visible_reflected_pdf(&gloss, nothing) == 0.0f);
    bounce.pdf = 7.0f;
    CHECK(mw_ggx_visible_draw_reflection_from(&gloss, &dry, &bounce) == MW_SOURCE_FAILED && bounce.pdf == 7.0f);
}

/* What takes words takes them from a source, and gives up where that fails. */
static void sources_serve(void)
{
    static const float low[3] = {-1, -1, -1}, high[3] = {1, 1, 1}, pixels[6] = {0, 1, 0, 1, 2, 0};
    mw_pcg32 rng = seeded(8), same = seeded(8);
    mw_source source = {from_pcg32, &same}, dry = {fails, NULL};
    mw_interval line;
    mw_aabb_3d cube;
    CHECK(mw_interval_init(&line, -1.0f, 1.0f) == MW_OK && mw_aabb_3d_init(&cube, low, high) == MW_OK);
    mw_region_3d round = {in_ball, NULL};
    mw_density_1d flat = {twice, NULL};
    float a[3] = {77, 77, 77}, b[3] = {77, 77, 77};
    CHECK(mw_region_3d_draw_from(&cube, &round, 100, &dry, a, NULL) == MW_SOURCE_FAILED && a[0] == 77.0f);
    CHECK(mw_region_3d_draw_from(&cube, &round, 100, &source, a, NULL) == MW_OK);
    CHECK(mw_region_3d_draw(&cube, &round, 100, &rng, b, NULL) == MW_OK && memcmp(a, b, sizeof a) == 0);
    CHECK(mw_region_3d_draw_from(&cube, &round, 0, &source, a, NULL) == MW_NOT_POSITIVE);
    CHECK(mw_bounded_1d_draw_from(&line, &flat, 4.0f, 99, &dry, a, NULL) == MW_SOURCE_FAILED);
    CHECK(mw_bounded_1d_draw_from(&line, &flat, NAN, 99, &source, a, NULL) == MW_NOT_FINITE);
    CHECK(mw_interval_init(&line, 0.0f, 1.0f) == MW_OK);
    CHECK(mw_bounded_1d_draw_from(&line, &flat, 4.0f, 99, &source, a, NULL) == MW_OK);
    CHECK(mw_bounded_1d_draw(&line, &flat, 4.0f, 99, &rng, b, NULL) == MW_OK && a[0] == b[0]);

    uint32_t marginal[2], conditional[6], copies[2][2] = {{3, 5}, {3, 5}};
    mw_lat_long_map sky;
    mw_pixel_sample seen = {{9, 9}, {0, 0, 0}, 0};
    CHECK(mw_lat_long_map_build(&sky, pixels, 3, 2, marginal, conditional) == MW_OK);
    CHECK(mw_lat_long_map_draw_pixel_from(&sky, &dry, &seen) == MW_SOURCE_FAILED && seen.pixel[0] == 9);
    CHECK(mw_lat_long_map_draw_pixel_from(&sky, &source, &seen) == MW_OK);
    CHECK(mw_lat_long_map_draw_pixel(&sky, &rng).direction[0] == seen.direction[0]);

    CHECK(mw_resample_stratified_from(copies[0], 2, 8, &source) == MW_OK);
    CHECK(mw_resample_stratified(copies[1], 2, 8, &rng) == MW_OK && copies[0][0] == copies[1][0]);
    CHECK(mw_resample_stratified_from(copies[0], 2, 8, &dry) == MW_SOURCE_FAILED);
    CHECK(mw_resample_stratified_from(copies[0], 0, 8, &dry) == MW_NO_WEIGHTS);
    mw_reservoir reservoir;
    bool taken = false;
    uint32_t item;
    mw_reservoir_init(&reservoir);
    CHECK(mw_reservoir_offer_from(&reservoir, 4, 1.0f, &dry, &taken) == MW_SOURCE_FAILED && !taken);
    CHECK(mw_reservoir_offer_from(&reservoir, 4, 1.0f, &source, &taken) == MW_OK && taken);
    CHECK(mw_reservoir_item(&reservoir, &item) && item == 4);
    CHECK(mw_reservoir_offer_from(&reservoir, 4, -1.0f, &source, &taken) != MW_OK);
}

int main(void)
{
    errors_have_texts();
    pcg32_is_the_published_one();
    integers_are_drawn();
    tables_select();
    tables_refuse();
    integers_by_two_words();
    sum_tree_changes();
    sum_tree_64_changes();
    a_tree_is_exact();
    streams_are_weighted();
    parts_are_chosen();
    maps_are_warps();
    counts_are_drawn();
    random_quantities_are_drawn();
    resampling_keeps_its_shares();
    rejection_ends();
    estimators_estimate();
    chain_1d();
    chain_2d();
    chain_3d();
    chain_4d();
    chain_6d();
    chain_8d();
    log_chain_1d();
    log_chain_2d();
    log_chain_3d();
    log_chain_4d();
    log_chain_6d();
    log_chain_8d();
    observations_do_not_underflow();
    zeros_are_sound();
    points_cover();
    orders_are_whole();
    frames_turn();
    lamps_are_total();
    sources_serve();
    return done("functions");
}
