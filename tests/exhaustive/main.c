/* SPDX-License-Identifier: MIT
 *
 * All 2^32 arguments of every unary kernel, on all processors: a few minutes. Prints the exact
 * error bounds; fails if one is larger than its header states. */
#include "exhaustive.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <threads.h>
#include <unistd.h>

enum { CHUNK_BITS = 22, CHUNKS = 1 << (32 - CHUNK_BITS), THREADS_MAX = 256 };

struct sweep {
    const struct exhaustive_kernel *kernel;
    struct exhaustive_range range;
    mtx_t lock; /* of the range */
    atomic_uint next_chunk;
    bool show_progress;
};

static int sweep_chunks(void *context)
{
    struct sweep *sweep = context;
    struct exhaustive_range range = {0};

    for (unsigned chunk; (chunk = atomic_fetch_add(&sweep->next_chunk, 1)) < CHUNKS;) {
        if (sweep->show_progress) fprintf(stderr, "\r%s: %u of %d", sweep->kernel->name, chunk + 1, CHUNKS);
        for (uint32_t i = 0; i < UINT32_C(1) << CHUNK_BITS; i++)
            exhaustive_add(&range, sweep->kernel, (uint32_t)chunk << CHUNK_BITS | i);
    }
    mtx_lock(&sweep->lock);
    exhaustive_merge(&sweep->range, &range);
    mtx_unlock(&sweep->lock);
    return 0;
}

static bool sweep_all(const struct exhaustive_kernel *kernel, long thread_count)
{
    struct sweep sweep = {.kernel = kernel, .show_progress = isatty(STDERR_FILENO)};
    thrd_t threads[THREADS_MAX];

    if (mtx_init(&sweep.lock, mtx_plain) != thrd_success) abort();
    for (long i = 0; i < thread_count; i++)
        if (thrd_create(&threads[i], sweep_chunks, &sweep) != thrd_success) abort();
    for (long i = 0; i < thread_count; i++)
        thrd_join(threads[i], NULL);
    mtx_destroy(&sweep.lock);
    if (sweep.show_progress) fputs("\r\x1B[K", stderr);
    return exhaustive_report(&sweep.range, kernel);
}

int main(void)
{
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    const long thread_count = processors < 1 ? 1 : processors > THREADS_MAX ? THREADS_MAX : processors;
    bool ok = true;

    setvbuf(stdout, NULL, _IOLBF, 0);
    for (size_t k = 0; k < EXHAUSTIVE_KERNELS; k++)
        ok = sweep_all(&exhaustive_kernels[k], thread_count) && ok;
    puts(ok ? "# all within the stated bounds" : "# a stated bound does not hold");
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
