/* SPDX-License-Identifier: MIT
 *
 * Every kernel of one 32-bit argument, and how far its result may be from the truth. All 2^32 arguments are
 * tried by `make exhaustive`, 2^24 of them by every test run. */
#ifndef TESTS_EXHAUSTIVE_H
#define TESTS_EXHAUSTIVE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct exhaustive_kernel {
    const char *name;
    const char *ulp;  /* the unit of the result's last place */
    double bound_ulp; /* what its header states */
    /* Result less truth, in units of the last place. Not a number: a promise other than accuracy is
     * broken (a range, an exact value, a symmetry). */
    double (*error_ulp)(uint32_t x);
};

enum { EXHAUSTIVE_KERNELS = 7 };
extern const struct exhaustive_kernel exhaustive_kernels[EXHAUSTIVE_KERNELS];

/* The extreme errors so far, and whose they are. */
struct exhaustive_range {
    double low_ulp, high_ulp;
    uint32_t low_at, high_at;
    uint64_t broken; /* arguments that broke a promise */
    uint32_t broken_at;
};

void exhaustive_add(struct exhaustive_range *range, const struct exhaustive_kernel *kernel, uint32_t x);
void exhaustive_merge(struct exhaustive_range *range, const struct exhaustive_range *other);

/* Prints the range, as a comment of TAP. Whether it is within the stated bound, and no promise broken. */
bool exhaustive_report(const struct exhaustive_range *range, const struct exhaustive_kernel *kernel);

#endif
