/* SPDX-License-Identifier: MIT
 *
 * Names are looked at as text, as they may say more than what is there; then the file that was opened is asked where it
 * lies, which no link can hide. */
#define _XOPEN_SOURCE 700
#include "files/companion.h"

#include "base/hex.h"
#include "files/inputs.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH_SIZE_B = 4096 };

static bool trusts;              /* --trust-paths */
static char bounds[PATH_SIZE_B]; /* companions_stay_in(), without a link, with its slash; empty: the model's folder */
static struct {
    char path[PATH_SIZE_B], folder[PATH_SIZE_B]; /* the folder with its slash; empty: the working folder */
    char real_folder[PATH_SIZE_B];               /* without a link, with its slash */
    char missing[PATH_SIZE_B];                   /* the path that was not found last */
    bool refused;
    struct error refusal; /* the first */
} model;

void companions_trust(void)
{
    trusts = true;
}

static void real_folder(const char *folder, char out[PATH_SIZE_B])
{
    char *real = realpath(*folder ? folder : ".", NULL);
    snprintf(out, PATH_SIZE_B, "%s%s", real ? real : "", real && strcmp(real, "/") == 0 ? "" : "/");
    free(real);
}

void companions_stay_in(const char *folder)
{
    trusts = false;
    real_folder(folder, bounds);
}

void companions_begin(const char *model_path)
{
    const char *slash = strrchr(model_path, '/');
    model.refused = false;
    model.missing[0] = '\0';
    snprintf(model.path, sizeof model.path, "%s", model_path);
    snprintf(model.folder, sizeof model.folder, "%.*s", slash ? (int)(slash - model_path) + 1 : 0, model_path);
    real_folder(model.folder, model.real_folder);
}

bool companions_refused(struct error *err)
{
    if (model.refused) *err = model.refusal;
    return model.refused;
}

void companions_refuse(const struct error *err)
{
    if (!model.refused) model.refusal = *err;
    model.refused = true;
}

void companions_pardon(void)
{
    model.refused = false;
}

static void refuse(const char *name, struct error *err)
{
    error_set(err, "%s: it names '%s', which lies outside of its folder; --trust-paths permits that", model.path, name);
    companions_refuse(err);
    errno = EPERM;
}

/* Names ---------------------------------------------------------------------------------------- */

/* What follows the folder; NULL: the path does not begin with it. */
static const char *behind(const char *path, const char *folder)
{
    const size_t folder_b = strlen(folder);
    return strncmp(path, folder, folder_b) == 0 ? path + folder_b : NULL;
}

/* How many folders the model's lies below the one that nothing may lead out of; 0 if that is the model's own. */
static int depth_of_folder(void)
{
    const char *below = *bounds ? behind(model.real_folder, bounds) : NULL;
    int depth = 0;
    for (; below && *below; below++)
        depth += *below == '/';
    return depth;
}

/* Steps that go nowhere count as none, and `..` leads up from wherever it is: a name that goes up and comes back may
 * lead out on the way. */
static bool leads_out(const char *name)
{
    int depth = depth_of_folder();
    if (*name == '/') return true;
    for (size_t length; *name; name += length + (name[length] == '/')) {
        length = strcspn(name, "/");
        const bool goes_up = length == 2 && name[0] == '.' && name[1] == '.';
        if (goes_up && --depth < 0) return true;
    }
    return false;
}

static bool too_long(struct error *err)
{
    errno = ENAMETOOLONG;
    return error_set(err, "%s: it names a file by a path that is too long", model.path);
}

/* They may come from Windows. */
static bool copy_name(const char *name, char out[PATH_SIZE_B], struct error *err)
{
    if (strlen(name) >= PATH_SIZE_B) return too_long(err);
    memcpy(out, name, strlen(name) + 1);
    for (char *c = out; *c; c++)
        if (*c == '\\') *c = '/';
    return true;
}

/* %20 becomes a blank. Whether there was such a thing. */
static bool decode_percent(char *name)
{
    char *to = name;
    for (const char *from = name; *from; to++) {
        const int high = *from == '%' ? hex_digit(from[1]) : -1, low = high >= 0 ? hex_digit(from[2]) : -1;
        *to = *from;
        if (low >= 0) *to = (char)(high << 4 | low);
        if (*to == '\\') *to = '/';
        if (*to == '\0') *to = '?';
        from += low >= 0 ? 3 : 1;
    }
    const bool changed = *to != '\0';
    *to = '\0';
    return changed;
}

/* Opening -------------------------------------------------------------------------------------- */

static bool lies_in_folder(FILE *file)
{
    const char *folder = *bounds ? bounds : model.real_folder;
    char link[64], place[PATH_SIZE_B];
    snprintf(link, sizeof link, "/proc/self/fd/%d", fileno(file));
    const ssize_t length = readlink(link, place, sizeof place);
    const size_t folder_b = strlen(folder);
    return length > 0 && (size_t)length > folder_b && memcmp(place, folder, folder_b) == 0;
}

static FILE *open_name(const char *name, const char *said, size_t most_b, size_t *size_b, struct error *err)
{
    char path[PATH_SIZE_B];
    if (!trusts && leads_out(name)) {
        refuse(said, err);
        return NULL;
    }
    const int length = snprintf(path, sizeof path, "%s%s", *name == '/' ? "" : model.folder, name);
    if (length >= PATH_SIZE_B) {
        too_long(err);
        return NULL;
    }
    FILE *file = input_open(path, most_b, size_b, err);
    if (file && (trusts || lies_in_folder(file))) {
        inputs_note(path);
        return file;
    }
    if (!file) return NULL;
    fclose(file);
    refuse(said, err);
    return NULL;
}

/* Whole paths into the model's folder are as good as names; libraries make such. Two slashes: Blender's word for it. */
static const char *in_folder(const char *path)
{
    const char *name = behind(path, "//");
    if (!name && *model.folder == '/') name = behind(path, model.folder);
    if (!name) name = behind(path, model.real_folder);
    return name && *name != '/' ? name : path;
}

FILE *companion_open(const char *name, size_t most_b, size_t *size_b, struct error *err)
{
    char wanted[PATH_SIZE_B];
    struct error second;
    if (!copy_name(name, wanted, err)) return NULL;
    FILE *file = open_name(in_folder(wanted), name, most_b, size_b, err);
    if (!file && decode_percent(wanted)) file = open_name(in_folder(wanted), name, most_b, size_b, &second);
    return file;
}

/* Having found no file, the library goes on with parts of its path behind the folder's: these look as absolute names
 * do, but the model has not said them. */
FILE *companion_open_path(const char *path, size_t most_b, size_t *size_b, struct error *err)
{
    if (strcmp(path, model.path) == 0) {
        FILE *file = input_open(path, most_b, size_b, err);
        if (file) inputs_note(path);
        return file;
    }
    const char *name = behind(path, model.folder);
    if (!name) name = path;
    if (*name == '/' && strstr(model.missing, name)) {
        error_set(err, "%s: %s", path, strerror(errno = ENOENT));
        return NULL;
    }
    FILE *file = companion_open(name, most_b, size_b, err);
    if (!file && *name != '/') snprintf(model.missing, sizeof model.missing, "%s", path);
    return file;
}
