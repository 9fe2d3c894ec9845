/* SPDX-License-Identifier: MIT
 *
 * The list: a letter, how far the run has come, then paths, each with a zero behind it, from the list's folder on where
 * they lie below it. Only names that are made of a path on the list and the run's word are ever removed or moved, and
 * only of lists that are the user's own: whoever makes one up can name no file that is not called so already. A lock is
 * asked for instead of a process number: it holds across containers, and ends with the process. */
#define _GNU_SOURCE /* getdelim() beside flock() */
#include "outputs/output_run.h"

#include "base/ending.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#define BEFORE_WORD ".limner-"
#define BEHIND_WORD ".run"

enum {
    WORD_LENGTH = 8,
    NAME_MAX_B = 200, /* of a name's 255 bytes: the rest is for what temporary names add */
    BEGIN_TRIES = 16,
    LOCK_TRIES = 100,
    LOCK_WAIT_MS = 10
};

enum progress_letter { WRITES = 'w', IS_COMPLETE = 'c' };

struct output_run {
    char word[WORD_LENGTH + 1];
    char *folder;    /* of the list, with its slash, or "." */
    char *list_path; /* NULL: there is no list */
    int list;        /* open, and locked */
    size_t count;    /* of outputs */
    struct leftover *leftover;
};

/* Names -------------------------------------------------------------------------------------- */

static size_t folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

char *output_folder_of(const char *path)
{
    const size_t length = folder_length(path);
    return length ? strndup(path, length) : strdup(".");
}

static bool make_word(char word[WORD_LENGTH + 1])
{
    static const char digits[] = "0123456789abcdefghijklmnopqrstuv";
    uint64_t random;
    if (getentropy(&random, sizeof random) != 0) return false;
    for (int i = 0; i < WORD_LENGTH; i++, random /= 32)
        word[i] = digits[random % 32];
    word[WORD_LENGTH] = '\0';
    return true;
}

char *output_run_name(const struct output_run *run, const char *path, size_t number, enum output_name which)
{
    char *name;
    const int folder_b = (int)folder_length(path);
    const int length = asprintf(&name, "%.*s%.*s.%s-%zu.%s", folder_b, path, NAME_MAX_B, path + folder_b, run->word,
                                number, which == OUTPUT_PART ? "part" : "old");
    return length < 0 ? NULL : name;
}

/* FOLDER/.limner-WORD.run */
static char *list_path(const char *folder, const char *word)
{
    char *path;
    const bool is_here = strcmp(folder, ".") == 0;
    return asprintf(&path, "%s" BEFORE_WORD "%s" BEHIND_WORD, is_here ? "" : folder, word) < 0 ? NULL : path;
}

/* Locks -------------------------------------------------------------------------------------- */

int output_folder_lock(const char *folder)
{
    const int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    for (int i = 0; descriptor >= 0 && i < LOCK_TRIES && flock(descriptor, LOCK_EX | LOCK_NB) != 0; i++)
        poll(NULL, 0, LOCK_WAIT_MS);
    return descriptor;
}

/* Of a file that has a name: who waits for a list may find it removed. */
static bool lock_list(int descriptor, struct stat *status)
{
    return flock(descriptor, LOCK_EX | LOCK_NB) == 0 && fstat(descriptor, status) == 0 && status->st_nlink == 1;
}

/* What killed runs left ---------------------------------------------------------------------- */

/* What is in the place is what was there when the run set it aside, or nothing. */
static bool is_untouched(const char *path, const char *old)
{
    struct stat here, aside;
    if (lstat(path, &here) != 0) return errno == ENOENT;
    return lstat(old, &aside) == 0 && here.st_dev == aside.st_dev && here.st_ino == aside.st_ino;
}

static void undo(const char *path, const char *part, const char *old)
{
    struct stat status;
    unlink(part);
    if (lstat(path, &status) != 0 && errno == ENOENT)
        (void)!rename(old, path);
    else
        unlink(old);
}

static void finish(const char *path, const char *part, const char *old)
{
    if (!is_untouched(path, old) || rename(part, path) != 0) unlink(part);
    unlink(old);
}

/* `listed` as it stands in the list of `run`. */
static void clean_output(const struct output_run *run, char progress, const char *listed, size_t number)
{
    char *path = NULL, *part = NULL, *old = NULL;
    const bool is_below = listed[0] != '/' && strcmp(run->folder, ".") != 0;
    if (asprintf(&path, "%s%s", is_below ? run->folder : "", listed) < 0) return;
    part = output_run_name(run, path, number, OUTPUT_PART);
    old = output_run_name(run, path, number, OUTPUT_OLD);
    if (part && old && progress == IS_COMPLETE) finish(path, part, old);
    if (part && old && progress == WRITES) undo(path, part, old);
    free(path);
    free(part);
    free(old);
}

static void clean_run(const struct output_run *run)
{
    char *listed = NULL;
    size_t size_b = 0, number = 0;
    FILE *list = fdopen(dup(run->list), "r");
    const int lock = list ? output_folder_lock(run->folder) : -1;
    const int progress = list ? getc(list) : EOF;
    while (list && getdelim(&listed, &size_b, '\0', list) > 0)
        clean_output(run, (char)progress, listed, number++);
    free(listed);
    if (list) fclose(list);
    if (lock >= 0) close(lock);
    unlink(run->list_path);
}

static bool is_list_name(const char *name)
{
    const size_t before_b = sizeof BEFORE_WORD - 1;
    return strlen(name) == before_b + WORD_LENGTH + sizeof BEHIND_WORD - 1 &&
           strncmp(name, BEFORE_WORD, before_b) == 0 && strcmp(name + before_b + WORD_LENGTH, BEHIND_WORD) == 0;
}

static void clean_if_killed(char *folder, const char *name)
{
    struct stat status;
    struct output_run run = {.folder = folder};
    memcpy(run.word, name + sizeof BEFORE_WORD - 1, WORD_LENGTH);
    run.list_path = list_path(folder, run.word);
    run.list = run.list_path ? open(run.list_path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC) : -1;
    if (run.list >= 0 && lock_list(run.list, &status) && S_ISREG(status.st_mode) && status.st_uid == geteuid())
        clean_run(&run);
    if (run.list >= 0) close(run.list);
    free(run.list_path);
}

static void clean_folder(char *folder)
{
    DIR *entries = opendir(folder);
    for (struct dirent *entry; entries && (entry = readdir(entries));)
        if (is_list_name(entry->d_name)) clean_if_killed(folder, entry->d_name);
    if (entries) closedir(entries);
}

/* A run -------------------------------------------------------------------------------------- */

/* Another run may take a list that is not locked yet for one that a killed run left. */
static bool open_list(struct output_run *run)
{
    struct stat status;
    const char progress = WRITES;
    run->list_path = list_path(run->folder, run->word);
    run->list = run->list_path ? open(run->list_path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600) : -1;
    run->leftover = run->list >= 0 ? ending_add(LEFTOVER_FILE, run->list_path) : NULL;
    if (run->leftover && lock_list(run->list, &status) && write(run->list, &progress, 1) == 1) return true;
    if (run->list >= 0) {
        unlink(run->list_path);
        close(run->list);
    }
    ending_forget(run->leftover);
    free(run->list_path);
    run->leftover = NULL;
    run->list_path = NULL;
    run->list = -1;
    return false;
}

struct output_run *output_run_begin(const char *path)
{
    struct output_run *run = calloc(1, sizeof *run);
    if (run) run->folder = output_folder_of(path);
    bool ok = run && run->folder && make_word(run->word);
    if (!ok) {
        if (run) free(run->folder);
        free(run);
        return NULL;
    }
    run->list = -1;
    ending_hold();
    clean_folder(run->folder);
    for (int i = 0; ok && i < BEGIN_TRIES && !open_list(run); i++)
        ok = make_word(run->word);
    ending_release();
    return run;
}

/* As it is found from the list's folder, whatever the working folder is then. */
static char *listed_path(const struct output_run *run, const char *path)
{
    const size_t folder_b = strcmp(run->folder, ".") == 0 ? 0 : strlen(run->folder);
    const char *below = path + folder_b;
    if (strncmp(path, run->folder, folder_b) == 0 && *below != '/') return strdup(below);
    char *folder = output_folder_of(path), *real = folder ? realpath(folder, NULL) : NULL, *listed = NULL;
    if (real && asprintf(&listed, "%s/%s", real, path + folder_length(path)) < 0) listed = NULL;
    free(folder);
    free(real);
    return listed;
}

size_t output_run_add(struct output_run *run, const char *path)
{
    char *listed = run->list >= 0 ? listed_path(run, path) : NULL;
    /* Numbers are those of the list: one that cannot be in it has an entry as well. */
    const char *entry = listed ? listed : "";
    if (run->list >= 0) (void)!write(run->list, entry, strlen(entry) + 1);
    free(listed);
    return run->count++;
}

void output_run_is_complete(struct output_run *run)
{
    const char progress = IS_COMPLETE;
    if (run->list >= 0) (void)!pwrite(run->list, &progress, 1, 0);
}

void output_run_end(struct output_run *run)
{
    if (!run) return;
    if (run->list >= 0) {
        unlink(run->list_path);
        close(run->list);
    }
    ending_forget(run->leftover);
    free(run->list_path);
    free(run->folder);
    free(run);
}
