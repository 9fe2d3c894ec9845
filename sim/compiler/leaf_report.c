/* SPDX-License-Identifier: MIT
 *
 * What was weighed, and what came of it, in one line. */
#include "compiler/leaf_report.h"

#include "base/printable.h"

#include <math.h>
#include <stdio.h>

static void print_parts(const struct leaf_report *leaves)
{
    printf("%zu dense part%s of %zu polygons", leaves->count, leaves->count > 1 ? "s" : "", leaves->polygons);
    for (size_t i = 0; i < leaves->count && i < LEAF_PARTS_TOLD; i++)
        printf("%s face %lu on (%zu)", i ? "," : ", of", (unsigned long)leaves->parts[i].face,
               leaves->parts[i].polygons);
    if (leaves->count > LEAF_PARTS_TOLD) printf(" ...");
}

void leaf_report_print(const struct leaf_report *leaves, const char *object)
{
    if (!leaves->count && !leaves->tried) return;
    if (object)
        printable_print(stdout, "  mesh leaf of '%s', not exact: ", object);
    else
        printf("  mesh leaves, not exact: ");
    if (leaves->count)
        print_parts(leaves);
    else
        printf("none");
    if (leaves->tried && !leaves->count)
        printf(", after %zu attempt%s; of the last one", leaves->attempts, leaves->attempts > 1 ? "s" : "");
    if (leaves->tried && !isnan(leaves->instructions))
        printf("; %.0f instead of %.0f instructions predicted", leaves->instructions, leaves->without_instructions);
    if (leaves->tried && !isnan(leaves->wrong_percent))
        printf("; %.4f %% of pixels wrong, at most %.4f %%", leaves->wrong_percent, leaves->bound_percent);
    if (leaves->dear_near)
        printf("; %zu part%s cost%s more seen from near", leaves->dear_near, leaves->dear_near > 1 ? "s" : "",
               leaves->dear_near > 1 ? "" : "s");
    putchar('\n');
}
