/* SPDX-License-Identifier: MIT
 *
 * O_NONBLOCK: else opening a pipe that nobody writes to would not return. It means nothing to regular files. */
#include "base/input_file.h"

#include "base/grow.h"
#include "base/inputs.h"
#include "base/streams.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *what_it_is(mode_t mode)
{
    if (S_ISDIR(mode)) return "is a folder, not a file";
    if (S_ISFIFO(mode)) return "is a pipe, not a regular file";
    if (S_ISSOCK(mode)) return "is a socket, not a regular file";
    return "is a device, not a regular file";
}

/* Closes it if it is not as it should be. */
static int check(int descriptor, const char *path, size_t most_b, struct stat *about, struct error *err)
{
    bool ok = fstat(descriptor, about) == 0 || error_set(err, "%s: %s", path, strerror(errno));
    if (ok && !S_ISREG(about->st_mode)) ok = error_set(err, "%s: %s", path, what_it_is(about->st_mode));
    if (ok && (unsigned long long)about->st_size > most_b)
        ok = error_set(err, "%s: more than %zu bytes: %lld", path, most_b, (long long)about->st_size);
    if (ok) inputs_note_file(about);
    if (ok) return descriptor;
    close(descriptor);
    errno = S_ISDIR(about->st_mode) ? EISDIR : EINVAL;
    return -1;
}

static FILE *file_of(int descriptor, const char *path, struct error *err)
{
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "rb") : NULL;
    if (file || descriptor < 0) return file;
    error_set(err, "%s: %s", path, strerror(errno));
    close(descriptor);
    return NULL;
}

FILE *input_open(const char *path, size_t most_b, size_t *size_b, struct error *err)
{
    struct stat about;
    int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0) /* a socket cannot be opened at all, and the reason given would be none */
        error_set(err, "%s: %s", path, errno == ENXIO ? "is not a regular file" : strerror(errno));
    else
        descriptor = check(descriptor, path, most_b, &about, err);
    if (descriptor >= 0 && size_b) *size_b = (size_t)about.st_size;
    return file_of(descriptor, path, err);
}

FILE *input_open_stream(const char *path, struct error *err)
{
    struct stat about;
    if (strcmp(path, "-") == 0) {
        if (fstat(STDIN_FILENO, &about) == 0) inputs_note_file(&about);
        return stdin;
    }
    if (stream_number(path) < 0) return input_open(path, SIZE_MAX, NULL, err);
    int descriptor = stream_open(path, O_RDONLY);
    if (descriptor < 0) error_set(err, "%s: %s", path, strerror(errno));
    if (descriptor >= 0 && (fstat(descriptor, &about) != 0 || !S_ISFIFO(about.st_mode)))
        descriptor = check(descriptor, path, SIZE_MAX, &about, err);
    return file_of(descriptor, path, err);
}

void input_close_stream(FILE *file)
{
    if (file && file != stdin) fclose(file);
}

bool input_is_regular(FILE *file)
{
    struct stat about;
    return fstat(fileno(file), &about) == 0 && S_ISREG(about.st_mode);
}

/* Lines -------------------------------------------------------------------------------------- */

static bool put(struct input_lines *lines, int byte, struct error *err)
{
    if (lines->length == lines->line_most_b)
        return error_set(err, "%s:%zu: the line is longer than %zu bytes", lines->path, lines->number,
                         lines->line_most_b);
    if (byte == '\0') return error_set(err, "%s:%zu: a NUL byte", lines->path, lines->number);
    lines->line = grow(lines->line, lines->length, &lines->capacity, 1);
    lines->line[lines->length++] = (char)byte;
    return true;
}

bool input_line(struct input_lines *lines, struct error *err)
{
    int byte;
    lines->length = 0;
    lines->number++;
    while ((byte = getc_unlocked(lines->file)) != EOF && byte != '\n')
        if (!put(lines, byte, err)) return false;
    if (ferror(lines->file)) return error_set(err, "%s: %s", lines->path, strerror(errno));
    if (byte == EOF && lines->length == 0) return false;
    if (lines->length && lines->line[lines->length - 1] == '\r') lines->length--;
    lines->line = grow(lines->line, lines->length, &lines->capacity, 1);
    lines->line[lines->length] = '\0';
    return true;
}

void input_lines_free(struct input_lines *lines)
{
    free(lines->line);
    lines->line = NULL;
}
