/*
 * The golden bits through the header: golden TABLE
 *
 * Each subject puts out the words that the table has of it, and finds the same point by every other
 * way that the header offers. Fails where a word differs, or where a line of the table is neither
 * checked nor of a subject that is known to be missing in C.
 */
#include "check.h"

#include <stdlib.h>

enum { INPUTS = 16, UNIFORMS = 12, WORDS = 12 };

/* Which end of a line is compared, where it varies how many words C lacks. */
enum only { ALL, FIRST, LAST };

struct out {
    const char *subject;
    int input;
    int count;
    uint32_t words[16];
    uint32_t skipped; /* one bit for each word that C lacks */
    enum only only;
};

struct subject {
    const char *name;
    void (*put)(int input, struct out *out);
};

/* A subject that C cannot express, and why. */
struct other {
    const char *name;
    const char *reason;
};

static const uint32_t uniforms[UNIFORMS][4];
static const uint32_t words[WORDS][2];

static void wrong(const struct out *out, const char *what)
{
    failures++;
    fprintf(stderr, "%s #%d: %s\n", out->subject, out->input, what);
}

static void expect_same(struct out *out, const void *a, const void *b, size_t size)
{
    checks++;
    if (memcmp(a, b, size) != 0)
        wrong(out, "another way leads to another point");
}

/* What was filled with 0xa5 before. */
static void expect_untouched(struct out *out, const void *memory, size_t size)
{
    checks++;
    for (size_t i = 0; i < size; i++)
        if (((const unsigned char *)memory)[i] != 0xa5) {
            wrong(out, "written beyond the end");
            break;
        }
}

static void expect_error(struct out *out, mw_error expected, mw_error error)
{
    checks++;
    if (error != expected)
        wrong(out, mw_error_text(error));
}

static void expect_density(struct out *out, double density)
{
    checks++;
    if (!(density > 0.0) && out->input != 9)
        wrong(out, "a sample of density 0");
}

static void put_uint32_t(struct out *out, uint32_t word)
{
    if (out->count < 16)
        out->words[out->count++] = word;
}

static void put_int32_t(struct out *out, int32_t word)
{
    put_uint32_t(out, (uint32_t)word);
}

static void put_uint64_t(struct out *out, uint64_t word)
{
    put_uint32_t(out, (uint32_t)(word >> 32));
    put_uint32_t(out, (uint32_t)word);
}

static void put_size_t(struct out *out, size_t index)
{
    put_uint32_t(out, (uint32_t)index);
}

static void put_float(struct out *out, float x)
{
    put_uint32_t(out, isnan(x) ? 0x7fc00000u : bits_of(x));
}

static bool refused(struct out *out, mw_error error)
{
    (void)out;
    return error != MW_OK;
}

static bool refused_with_word(struct out *out, mw_error error)
{
    if (error != MW_OK)
        put_uint32_t(out, (uint32_t)error - 1);
    return error != MW_OK;
}

static mw_pcg32 generator(int input)
{
    mw_pcg32 rng;
    mw_pcg32_init(&rng, 0x5eed + (uint64_t)input, 54);
    return rng;
}

static float given_float(int input, int i)
{
    return float_of(uniforms[input][i]);
}

static uint32_t given_uint32_t(int input, int i)
{
    return words[input][i > 0];
}

/* A point of words, which may lie anywhere. */
static uint32_t anywhere_uint32_t(int input, int i)
{
    return input < WORDS ? words[input][i > 0] : 0x20000000u;
}

static int32_t anywhere_int32_t(int input, int i)
{
    return (int32_t)anywhere_uint32_t(input, i);
}

#include "subjects.h"

#define LENGTH(array) (sizeof(array) / sizeof(array)[0])

static char **lines;
static size_t line_count;

static bool read_table(const char *path)
{
    FILE *file = fopen(path, "r");
    if (!file)
        return false;
    char line[512];
    while (fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = '\0';
        if (line[0] == '#')
            continue;
        lines = (char **)realloc(lines, (line_count + 1) * sizeof *lines);
        lines[line_count] = (char *)malloc(strlen(line) + 1);
        strcpy(lines[line_count++], line);
    }
    fclose(file);
    return line_count > 0;
}

/* The line that begins so, followed by a comma or the end, which is taken out of the table. */
static char *take(const char *start)
{
    size_t length = strlen(start);
    for (size_t i = 0; i < line_count; i++)
        if (lines[i] && strncmp(lines[i], start, length) == 0 &&
            (lines[i][length] == ',' || lines[i][length] == '\0')) {
            char *line = lines[i];
            lines[i] = NULL;
            return line;
        }
    return NULL;
}

/* A word of question marks is any. */
static bool like(const char *found, const char *text, bool whole)
{
    for (; *text; found++, text++)
        if (*found != *text && (*text != '?' || !*found))
            return false;
    return !whole || !*found;
}

static void compare(struct out *out)
{
    char start[256], text[256] = "";
    snprintf(start, sizeof start, "%s #%d", out->subject, out->input);
    char *line = take(start);
    const char *found = line ? line + strlen(start) : "";
    for (int i = 0, length = 0; i < out->count; i++)
        length += out->skipped >> i & 1 ? sprintf(text + length, ",????????")
                                        : sprintf(text + length, ",%08x", out->words[i]);
    if (out->only == LAST && strlen(found) > strlen(text))
        found += strlen(found) - strlen(text);
    checks++;
    if (!line || !like(found, text, out->only != FIRST)) {
        wrong(out, "other bits");
        fprintf(stderr, "  here  %s\n  table %s\n", text, line ? line : "has no such line");
    }
    free(line);
}

#include "others.h"
#include "others_tables.h"
#include "others_orders.h"
#include "others_lamps.h"
#include "others_rejection.h"

int main(int count, char **arguments)
{
    if (count != 2 || !read_table(arguments[1])) {
        fprintf(stderr, "golden TABLE\n");
        return 2;
    }
    size_t checked = LENGTH(subjects) + LENGTH(by_hand), left = 0;
    for (int input = 0; input < INPUTS; input++) {
        for (size_t i = 0; i < LENGTH(subjects); i++) {
            struct out out = {subjects[i].name, input, 0, {0}, 0, ALL};
            subjects[i].put(input, &out);
            compare(&out);
        }
        float u[4];
        for (int k = 0; k < 4; k++)
            u[k] = input < UNIFORMS ? given_float(input, k) : grid(input);
        for (size_t i = 0; i < LENGTH(by_hand); i++) {
            struct out out = {by_hand[i].name, input, 0, {0}, 0, ALL};
            by_hand[i].put(u, input, &out);
            compare(&out);
        }
    }
    for (size_t i = 0; i < LENGTH(others); i++) {
        if (strcmp(others[i].reason, "it is no warp") != 0)
            printf("not in C: %s: %s\n", others[i].name, others[i].reason);
        for (int input = 0; input < INPUTS; input++) {
            char start[256];
            snprintf(start, sizeof start, "%s #%d", others[i].name, input);
            char *line = take(start);
            left += line != NULL;
            free(line);
        }
    }
    size_t unknown = 0;
    for (size_t i = 0; i < line_count; i++) {
        if (lines[i] && strncmp(lines[i], "libm ", 5) != 0 && unknown++ < 5)
            fprintf(stderr, "neither checked nor listed: %s\n", lines[i]);
        free(lines[i]);
    }
    free(lines);
    failures += unknown > 0;
    printf("%zu subjects, %zu of them at %d inputs each; %zu lines of the others\n",
           LENGTH(subjects) + LENGTH(others), checked, INPUTS, left);
    return done("golden bits in C");
}
