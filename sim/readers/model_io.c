/* SPDX-License-Identifier: MIT
 *
 * Files for the importer library, read whole into memory. One allocation holds the library's
 * handle, our own record and the bytes; closing the handle frees it. */
#include "readers/model_io.h"

#include "base/inputs.h"
#include "files/companion.h"
#include "files/whole_file.h"
#include "readers/obj.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct model_file {
    struct aiFile handle; /* first, so that the library's pointer is also ours */
    size_t at_b, size_b;
    char bytes[];
};

static struct model_file *own(struct aiFile *handle)
{
    return (struct model_file *)(void *)handle;
}

static size_t file_read(struct aiFile *handle, char *buffer, size_t item_b, size_t count)
{
    struct model_file *file = own(handle);
    if (item_b == 0) return 0;
    size_t left = (file->size_b - file->at_b) / item_b;
    if (count > left) count = left;
    memcpy(buffer, file->bytes + file->at_b, count * item_b);
    file->at_b += count * item_b;
    return count;
}

static size_t file_write(struct aiFile *handle, const char *buffer, size_t item_b, size_t count)
{
    (void)handle, (void)buffer, (void)item_b, (void)count;
    return 0;
}

static size_t file_tell(struct aiFile *handle)
{
    return own(handle)->at_b;
}
static size_t file_size(struct aiFile *handle)
{
    return own(handle)->size_b;
}
static void file_flush(struct aiFile *handle)
{
    (void)handle;
}

static enum aiReturn file_seek(struct aiFile *handle, size_t offset, enum aiOrigin origin)
{
    struct model_file *file = own(handle);
    size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? file->at_b : file->size_b;
    size_t at_b = base + offset; /* a negative offset wraps, and so ends where it should */
    if (at_b > file->size_b) return aiReturn_FAILURE;
    file->at_b = at_b;
    return aiReturn_SUCCESS;
}

static struct model_file *read_whole(FILE *stream, size_t size_b)
{
    struct model_file *file = calloc(1, sizeof *file + size_b);
    if (!file) return NULL;
    file->size_b = fread(file->bytes, 1, size_b, stream);
    return file;
}

static struct model_file *copy_of(const char *bytes, size_t size_b)
{
    struct model_file *file = calloc(1, sizeof *file + size_b);
    if (!file) return NULL;
    file->size_b = size_b;
    memcpy(file->bytes, bytes, size_b);
    return file;
}

static struct model_file *read_path(const char *path)
{
    struct error ignored; /* what may not be read is known to companion.h */
    size_t size_b = 0;
    FILE *stream = companion_open_path(path, MODEL_FILE_MOST_B, &size_b, &ignored);
    if (!stream) return NULL;
    struct model_file *file = size_b ? read_whole(stream, size_b) : NULL;
    fclose(stream);
    return file;
}

static struct model_file *open_any(const struct model_io_instead *instead, const char *path)
{
    const struct whole_file *materials = instead->materials;
    if (path_has_suffix(path, OBJ_MATERIALS)) return copy_of(materials->bytes, materials->size_b);
    if (!instead->bytes || strcmp(path, instead->path) != 0) return read_path(path);
    if (!instead->is_noted) inputs_note(path);
    return copy_of(instead->bytes, instead->size_b);
}

static struct aiFile *file_open(struct aiFileIO *io, const char *path, const char *mode)
{
    const struct model_io_instead *instead = (const struct model_io_instead *)(const void *)io->UserData;
    if (mode[0] != 'r') return NULL;
    struct model_file *file = open_any(instead, path);
    if (!file) return NULL;
    file->handle = (struct aiFile){.ReadProc = file_read,
                                   .WriteProc = file_write,
                                   .TellProc = file_tell,
                                   .FileSizeProc = file_size,
                                   .SeekProc = file_seek,
                                   .FlushProc = file_flush};
    return &file->handle;
}

static void file_close(struct aiFileIO *io, struct aiFile *handle)
{
    (void)io;
    free(handle);
}

struct aiFileIO model_io(const struct model_io_instead *instead)
{
    return (struct aiFileIO){
        .OpenProc = file_open, .CloseProc = file_close, .UserData = (char *)(void *)(uintptr_t)instead};
}

bool model_io_check(const char *path, struct error *err)
{
    size_t size_b = 0;
    FILE *stream = input_open(path, MODEL_FILE_MOST_B, &size_b, err);
    if (!stream) return false;
    fclose(stream);
    return size_b > 0 || error_set(err, "%s: the file is empty", path);
}
