/* SPDX-License-Identifier: MIT
 *
 * Runs a fuzz target on files, and on all files of folders, one after the other, without libFuzzer: TARGET PATH...
 * Coverage is measured so, and an input that broke a promise is looked at so. */
#define _XOPEN_SOURCE 700
#include "fuzz/fuzz.h"

#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

enum { INPUT_MAX_B = 1 << 16, FOLDERS_OPEN = 8 };

static const struct fuzz_target *target;
static size_t inputs, failures;

static int replay(const char *path, const struct stat *status, int kind, struct FTW *place)
{
    uint8_t *bytes;

    (void)place;
    if (kind != FTW_F || status->st_size > INPUT_MAX_B) return 0;
    FILE *file = fopen(path, "rb");
    if (!file) return 0;
    bytes = malloc((size_t)status->st_size + 1);
    const size_t size_b = fread(bytes, 1, (size_t)status->st_size, file);
    fclose(file);
    uint8_t *exact = realloc(bytes, size_b ? size_b : 1); /* so that a sanitizer sees a step beyond it */
    const char *broken = target->run(exact, size_b);
    if (broken) fprintf(stderr, "%s: %s\n", path, broken);
    inputs++;
    failures += broken != NULL;
    free(exact);
    return 0;
}

int main(int argc, char **argv)
{
    target = argc > 1 ? fuzz_find(argv[1]) : NULL;
    if (!target) {
        fputs("replay: TARGET PATH...\n", stderr);
        return EXIT_FAILURE;
    }
    for (int i = 2; i < argc; i++)
        nftw(argv[i], replay, FOLDERS_OPEN, FTW_PHYS);
    printf("%s: %zu inputs, %zu broke a promise\n", target->name, inputs, failures);
    return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
