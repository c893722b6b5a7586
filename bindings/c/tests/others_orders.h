/* More of others.h: shuffles, choices, permutations, Latin hypercubes and the order of a picture. */
static uint32_t fold(uint32_t all, uint32_t word)
{
    return (all << 7 | all >> 25) ^ word;
}

static uint32_t folded(const uint32_t *list, size_t count)
{
    uint32_t all = 0;
    for (size_t i = 0; i < count; i++)
        all = fold(all, list[i]);
    return all;
}

static void put_choices(uint32_t c, uint32_t d, mw_pcg32 *rng, struct out *out)
{
    uint32_t all = 0, place = 99;
    mw_choice_in_order in_order;
    mw_choice_of_stream of_stream;
    if (made(out, mw_choice_in_order_init(&in_order, c & 31, d & 63))) {
        for (int i = 0; i < 64; i++)
            all = fold(all, mw_choice_in_order_draw(&in_order, rng));
        put_uint32_t(out, all ^ (uint32_t)mw_choice_in_order_take(&in_order, 0));
    }
    if (made(out, mw_choice_of_stream_init(&of_stream, c & 7))) {
        mw_choice_of_stream_take(&of_stream, d, &place);
        put_uint32_t(out, place);
        all = 0;
        for (int i = 0; i < 64; i++) {
            place = 99;
            mw_choice_of_stream_draw(&of_stream, rng, &place);
            all = fold(all, place);
        }
        put_uint32_t(out, all);
    }
}

static void shuffles(four u, int input, struct out *out)
{
    uint32_t stirred[4], deck[52], all = 0;
    uint16_t many[300];
    mw_pcg32 rng = generator(input);
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1];
    for (uint32_t i = 0; i < 52; i++)
        deck[i] = i;
    for (uint16_t i = 0; i < 300; i++)
        many[i] = i;
    for (int i = 0; i < 2; i++)
        mw_shuffle(deck, 52, sizeof deck[0], &rng);
    put_uint32_t(out, folded(deck, 52));
    for (int i = 0; i < 2; i++)
        expect_error(out, MW_OK, mw_choose(deck, 52, sizeof deck[0], 51, &rng));
    put_uint32_t(out, folded(deck, 52));
    for (int i = 0; i < 2; i++)
        mw_shuffle(many, 300, sizeof many[0], &rng);
    for (int i = 0; i < 300; i++)
        all = fold(all, many[i]);
    put_uint32_t(out, all);
    if (made(out, mw_choose(deck, 52, sizeof deck[0], a >> 26, &rng))) {
        put_uint32_t(out, folded(deck, a >> 26));
        put_uint32_t(out, folded(deck + (a >> 26), 52 - (a >> 26)));
    }
    expect_error(out, MW_OK, mw_choose(many, 300, sizeof many[0], 5, &rng));
    if (made(out, mw_choose(many, 300, sizeof many[0], b >> 23, &rng)))
        put_uint32_t(out, 0);
    expect_error(out, MW_OK, mw_choose(many, 300, sizeof many[0], 7, &rng));
    all = 0;
    for (int i = 0; i < 7; i++)
        all = fold(all, many[i]);
    put_uint32_t(out, all);
    put_uint32_t(out, mw_pcg32_next(&rng));
    put_choices(stirred[2], stirred[3], &rng, out);
}

static void permutations(four u, int input, struct out *out)
{
    uint32_t stirred[4];
    (void)input;
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1], c = stirred[2], d = stirred[3];
    const uint32_t counts[4] = {a & 15, (b & 1023) + 1, c, d | 1u << 31};
    for (int k = 0; k < 4; k++) {
        const uint32_t count = counts[k], places[4] = {0, count - 1, (count - 1) / 2, c};
        uint32_t numbers = 0, back = 0;
        mw_permutation order;
        if (!made(out, mw_permutation_init(&order, count, a)))
            continue;
        for (int i = 0; i < 4; i++) {
            uint32_t found = count, place = count;
            const mw_error expected = places[i] < count ? MW_OK : MW_OUT_OF_RANGE;
            expect_error(out, expected, mw_permutation_get(&order, places[i], &found));
            expect_error(out, expected, mw_permutation_index_of(&order, places[i], &place));
            numbers = fold(numbers, found);
            back = fold(back, place);
        }
        put_uint32_t(out, numbers);
        put_uint32_t(out, back);
    }
    for (int k = 0; k < 3; k++) {
        const uint32_t indices[4] = {0, 1, counts[k] - 1, d};
        uint32_t all = 0;
        mw_latin_hypercube points;
        if (!made(out, mw_latin_hypercube_init(&points, counts[k], a)))
            continue;
        for (int i = 0; i < 4; i++)
            all = fold(all, mw_latin_hypercube_word(&points, indices[i], d & 3));
        put_uint32_t(out, all);
    }
}

static void screens(four u, int input, struct out *out)
{
    uint32_t stirred[4];
    (void)input;
    stir(u, stirred);
    const uint32_t a = stirred[0], b = stirred[1], c = stirred[2], d = stirred[3];
    const uint32_t sizes[4][3] = {
        {1920, 1080, 4}, {(b & 1023) + 1, c & 1023, b >> 28}, {c, d, d & 3}, {1, 1, 32}};
    for (int k = 0; k < 4; k++) {
        const uint32_t x = c & 2047, y = d & 1023;
        uint32_t all = 0;
        mw_screen screen;
        if (!made(out, mw_screen_init(&screen, sizes[k][0], sizes[k][1], sizes[k][2], a)))
            continue;
        put_uint32_t(out, mw_screen_index(&screen, x, y, d >> 28));
        for (uint32_t dimension = 0; dimension < 3; dimension++)
            all = fold(all, mw_screen_word(&screen, x, y, c >> 28, dimension));
        put_uint32_t(out, all);
        put_uint32_t(out, mw_screen_word(&screen, x, y, d, 1) ^ mw_screen_word(&screen, a, d, c, 9));
    }
}
