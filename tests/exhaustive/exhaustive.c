/* SPDX-License-Identifier: MIT
 *
 * The truths: integers for the reciprocals (r and 2^k / m are compared by multiplication, which 64 bits hold),
 * the library's doubles for sine and cosine, 2^-20 of an ulp fine. */
#include "exhaustive.h"

#include "camera.h"
#include "math/fixed.h"

#include <math.h>
#include <stdio.h>

static const double PI = 3.14159265358979323846;

/* 0 is nobody's argument here: the callers never pass it. */
static double clz_error(uint32_t x)
{
    if (x == 0) return 0;
    const uint8_t zeros = clz_u32(x);
    return zeros <= 31 && x >> (31 - zeros) == 1 ? 0 : NAN;
}

typedef uint32_t recip(uint32_t z, uint8_t *shift);

/* r less the truth, 2^(31 + bits) over the mantissa; and r must lie in low .. high. */
static double recip_error(uint32_t z, recip *of, int bits, uint32_t low, uint32_t high)
{
    uint8_t zeros;

    if (z == 0) return 0;
    const uint32_t r = of(z, &zeros);
    const uint64_t mantissa_q31 = (uint64_t)z << zeros, product = r * mantissa_q31;
    if (mantissa_q31 >> 31 != 1 || r < low || r > high) return NAN;
    return (double)(int64_t)(product - (UINT64_C(1) << (31 + bits))) / (double)mantissa_q31;
}

static double recip_q24_error(uint32_t z)
{
    return recip_error(z, recip_q24, 24, 1u << 23, 65535u << 8);
}

static double recip_q16_error(uint32_t z)
{
    return recip_error(z, recip_q16, 16, 1u << 15, 65535);
}

/* Never so large that the projection could overflow: r times the mantissa is at most 2^46 + 2^33. */
static double recip_q15_error(uint32_t z)
{
    uint8_t zeros = 0;
    const uint64_t recip_q15 = z ? recip_q15_of(z, &zeros) : 0;

    if (recip_q15 * ((uint64_t)z << zeros) > (UINT64_C(1) << 46) + (UINT64_C(1) << 33)) return NAN;
    return recip_error(z, recip_q15_of, 15, 1u << 14, 1u << 15);
}

static double recip_q31_error(uint32_t z)
{
    return recip_error(z, recip_q31_of, 31, 1u << 30, INT32_MAX);
}

/* Within -1..1, antisymmetric, and exact at the quarters. */
static bool sine_is_sound(uint32_t angle, int32_t sine_q30)
{
    if (sine_q30 < -(1 << 30) || sine_q30 > 1 << 30 || lim_sin_q30(0 - angle) != -sine_q30) return false;
    if (angle % LIM_ANGLE_QUARTER != 0) return true;
    static const int32_t quarters_q30[4] = {0, 1 << 30, 0, -(1 << 30)};
    return sine_q30 == quarters_q30[angle / LIM_ANGLE_QUARTER];
}

static double sine_error(uint32_t angle)
{
    const int32_t sine_q30 = lim_sin_q30(angle);

    return sine_is_sound(angle, sine_q30) ? sine_q30 - 1073741824.0 * sin(2 * PI * angle / 4294967296.0) : NAN;
}

static double cosine_error(uint32_t angle)
{
    const int32_t cosine_q30 = lim_cos_q30(angle);

    if (cosine_q30 != lim_cos_q30(0 - angle)) return NAN;
    return cosine_q30 - 1073741824.0 * cos(2 * PI * angle / 4294967296.0);
}

const struct exhaustive_kernel exhaustive_kernels[EXHAUSTIVE_KERNELS] = {
    {"clz_u32", "1", 0, clz_error},
    {"recip_q24", "2^-24", 410, recip_q24_error},
    {"recip_q16", "2^-16", 1.6, recip_q16_error},
    {"recip_q15_of", "2^-15", 1.3, recip_q15_error},
    {"recip_q31_of", "2^-31", 3, recip_q31_error},
    {"lim_sin_q30", "2^-30", 3.3, sine_error},
    {"lim_cos_q30", "2^-30", 3.3, cosine_error},
};

void exhaustive_add(struct exhaustive_range *range, const struct exhaustive_kernel *kernel, uint32_t x)
{
    const double error_ulp = kernel->error_ulp(x);

    if (isnan(error_ulp)) {
        range->broken++;
        range->broken_at = x;
    } else if (error_ulp < range->low_ulp) {
        range->low_ulp = error_ulp;
        range->low_at = x;
    } else if (error_ulp > range->high_ulp) {
        range->high_ulp = error_ulp;
        range->high_at = x;
    }
}

void exhaustive_merge(struct exhaustive_range *range, const struct exhaustive_range *other)
{
    if (other->low_ulp < range->low_ulp) range->low_ulp = other->low_ulp, range->low_at = other->low_at;
    if (other->high_ulp > range->high_ulp) range->high_ulp = other->high_ulp, range->high_at = other->high_at;
    if (other->broken) range->broken_at = other->broken_at;
    range->broken += other->broken;
}

bool exhaustive_report(const struct exhaustive_range *range, const struct exhaustive_kernel *kernel)
{
    const bool within = range->low_ulp >= -kernel->bound_ulp && range->high_ulp <= kernel->bound_ulp;

    printf("# %-12s error %+.4f (at %lu) .. %+.4f (at %lu) units of %s; stated: %g\n", kernel->name, range->low_ulp,
           (unsigned long)range->low_at, range->high_ulp, (unsigned long)range->high_at, kernel->ulp,
           kernel->bound_ulp);
    if (range->broken)
        printf("# %s breaks a promise for %llu arguments, %lu among them\n", kernel->name,
               (unsigned long long)range->broken, (unsigned long)range->broken_at);
    return within && !range->broken;
}
