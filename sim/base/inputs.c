/* SPDX-License-Identifier: MIT
 *
 * Lists for the whole process: files are opened by libraries' callbacks, which nobody hands anything to. */
#include "base/inputs.h"

#include "base/grow.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/uio.h>
#include <unistd.h>

static struct {
    struct input_file_id {
        dev_t device;
        ino_t number;
    } * files;
    char **paths;
    size_t file_count, file_capacity, path_count, path_capacity;
} inputs;

static int sent_to = -1; /* -1: this process keeps them */

void inputs_send_to(int descriptor)
{
    sent_to = descriptor;
}

/* How a path goes to the parent: this letter, the path, a zero. */
enum { SENT_OPENED = 'o', SENT_NAMED = 'n' };

/* A file that the parent does not hear of could be overwritten: then it hears of a failure. */
static void send_path(char how, const char *path)
{
    const size_t path_b = strlen(path) + 1;
    const struct iovec parts[] = {{&how, 1}, {(void *)(uintptr_t)path, path_b}};
    if (writev(sent_to, parts, 2) != (ssize_t)path_b + 1) _exit(EXIT_FAILURE);
}

void inputs_note(const char *path)
{
    if (sent_to >= 0) {
        send_path(SENT_OPENED, path);
        return;
    }
    inputs.paths = grow(inputs.paths, inputs.path_count, &inputs.path_capacity, sizeof *inputs.paths);
    inputs.paths[inputs.path_count] = grow_zeroed(strlen(path) + 1, 1);
    memcpy(inputs.paths[inputs.path_count++], path, strlen(path));
    inputs_note_name(path);
}

void inputs_note_file(const struct stat *status)
{
    if (!S_ISREG(status->st_mode) || inputs_have(status)) return;
    inputs.files = grow(inputs.files, inputs.file_count, &inputs.file_capacity, sizeof *inputs.files);
    inputs.files[inputs.file_count++] = (struct input_file_id){status->st_dev, status->st_ino};
}

void inputs_note_name(const char *path)
{
    struct stat status;
    if (sent_to >= 0)
        send_path(SENT_NAMED, path);
    else if (stat(path, &status) == 0)
        inputs_note_file(&status);
}

void inputs_receive(FILE *stream)
{
    char *path = NULL;
    size_t size_b = 0;
    rewind(stream);
    while (getdelim(&path, &size_b, '\0', stream) > 0)
        (*path == SENT_OPENED ? inputs_note : inputs_note_name)(path + 1);
    free(path);
}

bool inputs_have(const struct stat *status)
{
    for (size_t i = 0; i < inputs.file_count; i++)
        if (inputs.files[i].device == status->st_dev && inputs.files[i].number == status->st_ino) return true;
    return false;
}

size_t inputs_count(void)
{
    return inputs.path_count;
}

const char *inputs_path(size_t index)
{
    return inputs.paths[index];
}

void inputs_forget(void)
{
    for (size_t i = 0; i < inputs.path_count; i++)
        free(inputs.paths[i]);
    free(inputs.paths);
    free(inputs.files);
    memset(&inputs, 0, sizeof inputs);
}
