/* SPDX-License-Identifier: MIT
 *
 * The fuzz targets under clang's libFuzzer: --target=NAME says which. Built by `make fuzz` alone. */
#include "fuzz/fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { UNMENDED_OF = 16 }; /* of so many mutated inputs, one stays as it is */

static const struct fuzz_target *target;

/* What libFuzzer calls, and what it offers. */
int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size_b);
size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t size_b, size_t max_b, unsigned seed);
size_t LLVMFuzzerMutate(uint8_t *bytes, size_t size_b, size_t max_b);

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    for (int i = 1; i < *argc; i++)
        if (strncmp((*argv)[i], "--target=", 9) == 0) target = fuzz_find((*argv)[i] + 9);
    if (target) return 0;
    fputs("fuzz: --target=NAME names no fuzz target\n", stderr);
    exit(1);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size_b)
{
    const char *broken = target->run(bytes, size_b);

    if (!broken) return 0;
    fprintf(stderr, "%s: %s\n", target->name, broken);
    abort();
}

size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t size_b, size_t max_b, unsigned seed)
{
    const size_t mutated_b = LLVMFuzzerMutate(bytes, size_b, max_b);

    return target->mend && seed % UNMENDED_OF ? target->mend(bytes, mutated_b, max_b) : mutated_b;
}
