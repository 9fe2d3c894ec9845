/* SPDX-License-Identifier: MIT
 *
 * The kernels under proof, in one unit; and what the prover has to know of the world outside. */
#include "shifts.h"

/*@ requires x != 0;
    assigns \nothing;
    ensures 0 <= \result <= 31 && 2147483648 <= x * (1 << \result) <= 4294967295 && (x >= 32768 ==> \result <= 16) &&
            (x < 2147483648 ==> \result >= 1) && (x < 1073741824 ==> \result >= 2); */
int __builtin_clz(unsigned x);

/* Of each build what it proves: the more a unit holds, the more the prover of any goal has to go through. */
#include "config.h"
#if LIM_PROFILE == LIM_PROFILE_FAST
#include "motion.c"
#include "movers/deform.c"
#endif

/* In the order in which the prover finds all: it depends on it. */
// clang-format off
#include "angle.c"
#include "view/cull.c"
#include "screen/edge.c"
#include "eye.c"
#include "math/fixed.c"
#include "view/perspective.h"
#include "view/transform.h"
// clang-format on
