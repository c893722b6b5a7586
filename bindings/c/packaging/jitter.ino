// Waiting times and channels at random, without floating point.
#include <microwarp.h>

static const uint32_t weights[4] = {1, 2, 3, 4};
static uint32_t words[4];
static mw_cdf channels;
static mw_fixed_exponential delays;
static mw_pcg32 rng;

void setup()
{
    Serial.begin(115200);
    mw_pcg32_init(&rng, 42, 54);
    // A mean of 20 ms in UQ16.16.
    mw_error error = mw_fixed_exponential_init_from_mean(&delays, 20ul << 16);
    if (error == MW_OK)
        error = mw_cdf_build_integers(weights, 4, words);
    if (error == MW_OK)
        error = mw_cdf_init(&channels, words, 4);
    if (error != MW_OK)
        Serial.println(mw_error_text(error));
}

void loop()
{
    Serial.println(mw_cdf_draw_index(&channels, &rng));
    delay(mw_fixed_exponential_draw(&delays, &rng) >> 16);
}
