/* SPDX-License-Identifier: MIT
 *
 * What the fuzz targets share. The file is in shared memory, without a name of its own, written anew for
 * each input and opened by its descriptor: nothing to clash, to clean up or to wait for. */
#include "fuzz.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

const struct fuzz_target *fuzz_find(const char *name)
{
    static const struct fuzz_target *const targets[] = {&fuzz_camera, &fuzz_camera_file, &fuzz_lim_file, &fuzz_render};

    for (size_t i = 0; i < sizeof targets / sizeof *targets; i++)
        if (strcmp(targets[i]->name, name) == 0) return targets[i];
    return NULL;
}

uint8_t fuzz_u8(struct fuzz_bytes *bytes)
{
    if (bytes->left_b == 0) return 0;
    bytes->left_b--;
    return *bytes->at++;
}

uint16_t fuzz_u16(struct fuzz_bytes *bytes)
{
    const uint8_t low = fuzz_u8(bytes);

    return (uint16_t)(low | fuzz_u8(bytes) << 8);
}

uint32_t fuzz_u32(struct fuzz_bytes *bytes)
{
    const uint16_t low = fuzz_u16(bytes);

    return low | (uint32_t)fuzz_u16(bytes) << 16;
}

uint8_t fuzz_below(struct fuzz_bytes *bytes, unsigned n)
{
    return (uint8_t)(fuzz_u8(bytes) % n);
}

static int scratch_file(void)
{
    static int fd = -1;
    char name[64];

    if (fd >= 0) return fd;
    snprintf(name, sizeof name, "/limner-fuzz-%ld", (long)getpid());
    fd = shm_open(name, O_RDWR | O_CREAT | O_EXCL, 0600);
    if (fd < 0 || shm_unlink(name) != 0) abort();
    return fd;
}

const char *fuzz_as_file(const uint8_t *bytes, size_t size_b)
{
    static char path[32];
    const int fd = scratch_file();

    if (pwrite(fd, bytes, size_b, 0) != (ssize_t)size_b || ftruncate(fd, (off_t)size_b) != 0) abort();
    snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    return path;
}
