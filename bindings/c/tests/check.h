/* What the tests share: counting what is wrong, and sources that work or fail. */
#ifndef CHECK_H
#define CHECK_H

#include "microwarp.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures;
static long checks;

#define CHECK(condition)                                                          \
    do {                                                                          \
        checks++;                                                                 \
        if (!(condition)) {                                                       \
            failures++;                                                           \
            fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
        }                                                                         \
    } while (0)

static inline uint32_t bits_of(float x)
{
    uint32_t word;
    memcpy(&word, &x, sizeof word);
    return word;
}

static inline float float_of(uint32_t word)
{
    float x;
    memcpy(&x, &word, sizeof x);
    return x;
}

/* A source over a generator of the library. */
static inline bool from_pcg32(void *context, uint32_t *word)
{
    *word = mw_pcg32_next((mw_pcg32 *)context);
    return true;
}

static inline bool fails(void *context, uint32_t *word)
{
    (void)context;
    (void)word;
    return false;
}

static inline int done(const char *name)
{
    printf("%s: %ld checks, %d failed\n", name, checks, failures);
    return failures > 0 || checks == 0;
}

#endif
