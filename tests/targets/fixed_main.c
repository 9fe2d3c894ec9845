/* SPDX-License-Identifier: MIT
 *
 * Prints what every fixed-point vector gives; the same program runs on the host and on every emulated
 * processor, and the texts must be equal. */
#include "console.h"

#include "fixed_vectors.h"

int main(void);

static void put_line(const char *line)
{
    console_put(line);
    console_put("\n");
}

int main(void)
{
    return fixed_vectors_run(put_line) != 0;
}
