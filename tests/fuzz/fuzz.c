/* SPDX-License-Identifier: MIT
 *
 * What the fuzz targets share. The file is in shared memory, without a name of its own, written anew for
 * each input and opened by its descriptor: nothing to clash, to clean up or to wait for. */
#include "fuzz.h"

#include "base/inputs.h"
#include "base/work_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

const struct fuzz_target *const fuzz_targets[] = {
    &fuzz_camera,  &fuzz_camera_file, &fuzz_lim_file, &fuzz_render,      &fuzz_features, &fuzz_mesh,
    &fuzz_movers,  &fuzz_obj,         &fuzz_gltf,     &fuzz_ply,         &fuzz_stl,      &fuzz_off,
    &fuzz_picture, &fuzz_wire_log,    &fuzz_qemu,     &fuzz_vcd,         &fuzz_text,     &fuzz_written,
    &fuzz_report,  &fuzz_wad,         &fuzz_long,     &fuzz_long_movers, &fuzz_touch,    NULL};

/* What sanitizers ask for. Libraries that read damaged files lose some of their memory; in the program that is a child
 * process's. */
const char *__lsan_default_suppressions(void);

const char *__lsan_default_suppressions(void)
{
    return "leak:operator new\nleak:libassimp\nleak:libgd\nleak:libarchive\n";
}

const struct fuzz_target *fuzz_find(const char *name)
{
    for (size_t i = 0; fuzz_targets[i]; i++)
        if (strcmp(fuzz_targets[i]->name, name) == 0) return fuzz_targets[i];
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

    inputs_forget();
    if (pwrite(fd, bytes, size_b, 0) != (ssize_t)size_b || ftruncate(fd, (off_t)size_b) != 0) abort();
    snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    return path;
}

static struct work_folder folder;

static void remove_folder(void)
{
    work_folder_remove(&folder);
}

const char *fuzz_as_named_file(const char *name, const uint8_t *bytes, size_t size_b)
{
    static char path[sizeof folder.path + 64];
    struct error err;

    inputs_forget(); /* one input after the other is read, and written again */
    if (!folder.path[0] && (!work_folder_make(&folder, &err) || atexit(remove_folder) != 0)) abort();
    snprintf(path, sizeof path, "%s/%s", folder.path, name);
    FILE *file = fopen(path, "wb");
    const bool wrote = file && (!size_b || fwrite(bytes, 1, size_b, file) == size_b);
    if (!wrote || fclose(file) != 0) abort();
    return path;
}

struct fuzz_bytes fuzz_part(struct fuzz_bytes *bytes, uint8_t mark)
{
    const uint8_t *end = bytes->left_b ? memchr(bytes->at, mark, bytes->left_b) : NULL;
    const struct fuzz_bytes part = {bytes->at, end ? (size_t)(end - bytes->at) : bytes->left_b};

    bytes->at += part.left_b + (end != NULL);
    bytes->left_b -= part.left_b + (end != NULL);
    return part;
}

char *fuzz_string(const struct fuzz_bytes *part)
{
    char *text = malloc(part->left_b + 1);

    if (!text) abort();
    if (part->left_b) memcpy(text, part->at, part->left_b);
    text[part->left_b] = '\0';
    return text;
}

const char *fuzz_check_refusal(const char *text, const char *thing)
{
    if (!text[0]) return "a refusal without a reason";
    if (thing && strncmp(text, thing, strlen(thing)) != 0) return "a refusal does not name the file";
    for (; *text; text++)
        if ((unsigned char)*text < ' ' || *text == 0x7F)
            return "a refusal of several lines, or with a control character";
    return NULL;
}
