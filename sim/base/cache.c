/* SPDX-License-Identifier: MIT
 *
 * A file an entry, named by its key in hexadecimal: a digest of what follows, then the bytes. Each is written beside
 * its place, and renamed. */
#include "base/cache.h"

#include "base/child.h"
#include "base/grow.h"
#include "base/sha256.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { FOLDER_B = 1024, NAME_DIGITS = 2 * CACHE_KEY_B, PATH_B = FOLDER_B + NAME_DIGITS + 16, STALE_S = 3600 };
_Static_assert((int)CACHE_KEY_B == (int)SHA256_B, "a key is a digest");

static char folder[FOLDER_B];         /* empty: there is none */
static uint8_t program_key[SHA256_B]; /* of this build */

/* The folder ---------------------------------------------------------------------------------- */

/* An absolute path in a variable; an empty one is none. */
static const char *path_in(const char *variable)
{
    const char *path = getenv(variable);
    return path && path[0] == '/' ? path : NULL;
}

static bool name_folder(char out[FOLDER_B])
{
    const char *named = path_in("LIMNER_CACHE"), *base = path_in("XDG_CACHE_HOME"), *home = path_in("HOME");
    int length = FOLDER_B;
    if (named)
        length = snprintf(out, FOLDER_B, "%s", named);
    else if (base)
        length = snprintf(out, FOLDER_B, "%s/limner", base);
    else if (home)
        length = snprintf(out, FOLDER_B, "%s/.cache/limner", home);
    return length < FOLDER_B;
}

/* A build is known by its file's size, and by when that was written. */
static bool find_program(void)
{
    struct stat about;
    char path[CHILD_PATH_B];
    if (!child_own_path(path) || stat(path, &about) != 0) return false;
    const int64_t program[] = {about.st_size, about.st_mtim.tv_sec, about.st_mtim.tv_nsec};
    sha256(program_key, (const uint8_t *)program, sizeof program);
    return true;
}

void cache_begin(void)
{
    char path[FOLDER_B];
    struct stat about;
    if (!name_folder(path) || !find_program()) return;
    mkdir(path, 0700); /* it may be there */
    if (stat(path, &about) == 0 && S_ISDIR(about.st_mode) && access(path, R_OK | W_OK | X_OK) == 0)
        memcpy(folder, path, sizeof folder);
}

bool cache_is_open(void)
{
    return folder[0] != '\0';
}

/* Keys ---------------------------------------------------------------------------------------- */

void cache_key(uint8_t key[CACHE_KEY_B], const uint8_t *bytes, size_t n_b)
{
    uint8_t both[2 * SHA256_B];
    sha256(both, bytes, n_b);
    memcpy(both + SHA256_B, program_key, SHA256_B);
    sha256(key, both, sizeof both);
}

static void entry_path(const uint8_t key[CACHE_KEY_B], char path[PATH_B])
{
    size_t at = (size_t)snprintf(path, PATH_B, "%s/", folder);
    for (int i = 0; i < CACHE_KEY_B; i++)
        at += (size_t)snprintf(path + at, PATH_B - at, "%02x", key[i]);
}

/* Finding ------------------------------------------------------------------------------------- */

/* All of a file, or NULL. */
static uint8_t *read_all(FILE *file, size_t *n_b)
{
    struct stat about;
    if (fstat(fileno(file), &about) != 0 || !S_ISREG(about.st_mode) || about.st_size < SHA256_B ||
        about.st_size > CACHE_ENTRY_MOST_B)
        return NULL;
    *n_b = (size_t)about.st_size;
    uint8_t *bytes = grow_zeroed(*n_b, 1);
    if (fread(bytes, 1, *n_b, file) == *n_b) return bytes;
    free(bytes);
    return NULL;
}

/* Whether the first bytes are the digest of the others, which take their place. */
static bool take_content(uint8_t *bytes, size_t *n_b)
{
    uint8_t digest[SHA256_B];
    sha256(digest, bytes + SHA256_B, *n_b - SHA256_B);
    if (memcmp(digest, bytes, SHA256_B) != 0) return false;
    *n_b -= SHA256_B;
    memmove(bytes, bytes + SHA256_B, *n_b);
    return true;
}

uint8_t *cache_find(const uint8_t key[CACHE_KEY_B], size_t *n_b)
{
    char path[PATH_B];
    if (!cache_is_open()) return NULL;
    entry_path(key, path);
    FILE *file = fopen(path, "rb");
    if (!file) return NULL;
    uint8_t *bytes = read_all(file, n_b);
    fclose(file);
    if (!bytes) return NULL;
    if (take_content(bytes, n_b)) {
        utimensat(AT_FDCWD, path, NULL, 0);
        return bytes;
    }
    free(bytes);
    return NULL;
}

/* Keeping ------------------------------------------------------------------------------------- */

struct entry {
    char name[NAME_DIGITS + 16];
    struct timespec used;
    off_t size_b;
};

static int by_use(const void *a, const void *b)
{
    const struct timespec *first = &((const struct entry *)a)->used, *second = &((const struct entry *)b)->used;
    if (first->tv_sec != second->tv_sec) return first->tv_sec < second->tv_sec ? -1 : 1;
    return (first->tv_nsec > second->tv_nsec) - (first->tv_nsec < second->tv_nsec);
}

/* What a process that was killed left half-written. */
static bool is_stale(const struct entry *entry)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    return strlen(entry->name) > NAME_DIGITS && now.tv_sec - entry->used.tv_sec > STALE_S;
}

static bool entry_set(struct entry *entry, DIR *list, const char *name)
{
    struct stat about;
    const size_t length = strlen(name);
    if (length < NAME_DIGITS || length >= sizeof entry->name) return false; /* none of ours */
    if (fstatat(dirfd(list), name, &about, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(about.st_mode)) return false;
    memcpy(entry->name, name, length + 1);
    entry->used = about.st_mtim;
    entry->size_b = about.st_size;
    return true;
}

static size_t list_entries(DIR *list, struct entry **entries)
{
    size_t count = 0, capacity = 0;
    *entries = NULL;
    for (const struct dirent *at; (at = readdir(list));) {
        *entries = grow(*entries, count, &capacity, sizeof **entries);
        count += entry_set(&(*entries)[count], list, at->d_name);
    }
    return count;
}

/* Those used longest ago go first. */
static void make_room(void)
{
    DIR *list = opendir(folder);
    if (!list) return;
    struct entry *entries;
    const size_t count = list_entries(list, &entries);
    off_t all_b = 0;
    if (count) qsort(entries, count, sizeof *entries, by_use);
    for (size_t i = 0; i < count; i++)
        all_b += entries[i].size_b;
    for (size_t i = 0; i < count; i++) {
        if (all_b <= CACHE_MOST_B && !is_stale(&entries[i])) continue;
        if (unlinkat(dirfd(list), entries[i].name, 0) == 0) all_b -= entries[i].size_b;
    }
    free(entries);
    closedir(list);
}

static bool write_entry(int descriptor, const uint8_t *bytes, size_t n_b)
{
    uint8_t digest[SHA256_B];
    FILE *file = fdopen(descriptor, "wb");
    if (!file) return close(descriptor), false;
    sha256(digest, bytes, n_b);
    const bool ok = fwrite(digest, 1, sizeof digest, file) == sizeof digest && fwrite(bytes, 1, n_b, file) == n_b;
    return fclose(file) == 0 && ok;
}

void cache_keep(const uint8_t key[CACHE_KEY_B], const uint8_t *bytes, size_t n_b)
{
    char path[PATH_B], part[PATH_B];
    if (!cache_is_open() || n_b > CACHE_ENTRY_MOST_B - SHA256_B) return;
    entry_path(key, path);
    if (snprintf(part, sizeof part, "%s.XXXXXX", path) >= (int)sizeof part) return;
    const int descriptor = mkstemp(part);
    if (descriptor < 0) return;
    if (!write_entry(descriptor, bytes, n_b) || rename(part, path) != 0) unlink(part);
    make_room();
}
