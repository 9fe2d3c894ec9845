/* SPDX-License-Identifier: MIT
 *
 * Names are looked at as text, as they may say more than what is there; then the file that was opened is asked where it
 * lies, which no link can hide. */
#define _XOPEN_SOURCE 700
#include "files/companion.h"

#include "base/inputs.h"
#include "base/names.h"
#include "files/any_case.h"
#include "files/name_forms.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { PATH_SIZE_B = NAME_FORM_B };

static bool trusts;              /* --trust-paths */
static char bounds[PATH_SIZE_B]; /* companions_stay_in(), without a link, with its slash; empty: the model's folder */
static struct {
    char path[PATH_SIZE_B], folder[PATH_SIZE_B]; /* the folder with its slash; empty: the working folder */
    char real_folder[PATH_SIZE_B];               /* without a link, with its slash */
    char missing[PATH_SIZE_B];                   /* the path that was not found last */
    bool refused;
    struct error refusal;            /* the first */
    struct names beside, other_case; /* files that were taken, and what the model calls them */
} model;

void companions_trust(void)
{
    trusts = true;
}

/* Empty if that cannot be found out. */
static void real_folder(const char *folder, char out[PATH_SIZE_B])
{
    char *real = realpath(*folder ? folder : ".", NULL);
    out[0] = '\0';
    if (real) snprintf(out, PATH_SIZE_B, "%s%s", real, strcmp(real, "/") == 0 ? "" : "/");
    free(real);
}

void companions_stay_in(const char *folder)
{
    trusts = false;
    real_folder(folder, bounds);
}

static void forget_names(void)
{
    names_free(&model.beside);
    names_free(&model.other_case);
}

void companions_begin(const char *model_path)
{
    const char *slash = strrchr(model_path, '/');
    if (strcmp(model.path, model_path) != 0) forget_names();
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

static void refuse(const char *name, struct error *err)
{
    error_set(err, "%s: it names '%s', which lies outside of its folder; --trust-paths permits that", model.path,
              name_end(name).text);
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

/* Opening -------------------------------------------------------------------------------------- */

enum place { PLACE_INSIDE, PLACE_OUTSIDE, PLACE_UNKNOWN };

/* Of a file that was opened by this path: a link in it that was changed meanwhile leads to another file. */
static enum place place_of(FILE *file, const char *path)
{
    const char *folder = *bounds ? bounds : model.real_folder;
    struct stat opened, named;
    char *real = realpath(path, NULL);
    const bool is_known = *folder && real && fstat(fileno(file), &opened) == 0 && stat(real, &named) == 0 &&
                          opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
    const bool is_inside = is_known && behind(real, folder);
    free(real);
    return !is_known ? PLACE_UNKNOWN : is_inside ? PLACE_INSIDE : PLACE_OUTSIDE;
}

struct search {
    const char *said;
    size_t most_b, *size_b;
    struct error *err;
    int why;         /* errno of the first failure */
    bool is_outside; /* one of its forms leads out of the folder */
    bool is_over;    /* a file was found, to be read or not */
};

static void fail(struct search *search, int why, const struct error *err)
{
    if (search->why && !search->is_over) return;
    search->why = why;
    *search->err = *err;
}

static void give_up(struct search *search, const struct error *err)
{
    search->is_over = true;
    fail(search, errno, err);
}

static FILE *take(struct search *search, FILE *file, const char *path)
{
    struct error err;
    const enum place place = trusts ? PLACE_INSIDE : place_of(file, path);
    search->is_over = true;
    if (place == PLACE_INSIDE) {
        inputs_note(path);
        return file;
    }
    fclose(file);
    if (place == PLACE_OUTSIDE) {
        refuse(search->said, &err);
    } else {
        error_set(&err, "%s: it names '%s', and this system does not tell whether that lies in its folder", model.path,
                  name_end(search->said).text);
        companions_refuse(&err);
        errno = EIO;
    }
    fail(search, errno, &err);
    return NULL;
}

static bool is_absent(int why)
{
    return why == ENOENT || why == ENOTDIR || why == ENAMETOOLONG;
}

/* By this name and no other. */
static FILE *open_name(struct search *search, const char *name)
{
    char path[PATH_SIZE_B];
    struct error err;
    if (!trusts && leads_out(name)) {
        search->is_outside = true;
        return NULL;
    }
    const int length = snprintf(path, sizeof path, "%s%s", *name == '/' ? "" : model.folder, name);
    if (length >= PATH_SIZE_B) {
        too_long(&err);
        fail(search, errno, &err);
        return NULL;
    }
    FILE *file = input_open(path, search->most_b, search->size_b, &err);
    if (file) return take(search, file, path);
    if (is_absent(errno))
        fail(search, errno, &err);
    else
        give_up(search, &err);
    return NULL;
}

/* Whole paths into the model's folder are as good as names; libraries make such. Two slashes: Blender's word for it. */
static const char *in_folder(const char *path)
{
    const char *name = behind(path, "//");
    if (!name && *model.folder == '/') name = behind(path, model.folder);
    if (!name && *model.real_folder) name = behind(path, model.real_folder);
    return name && *name != '/' ? name : path;
}

static void note_found(struct names *names, const char *found, const char *said)
{
    char text[2 * PATH_SIZE_B];
    const int length = snprintf(text, sizeof text, "%s' for '%s", found, said);
    names_add(names, text, (size_t)length < sizeof text ? (size_t)length : sizeof text - 1);
}

static FILE *open_in_any_case(struct search *search, const char *name, struct names *names)
{
    char found[PATH_SIZE_B];
    if (leads_out(name) || !any_case_find(model.folder, name, found, sizeof found)) return NULL;
    FILE *file = open_name(search, found);
    if (file) note_found(names, found, search->said);
    return file;
}

typedef FILE *open_form(struct search *search, const char *name);

static FILE *open_as_said(struct search *search, const char *name)
{
    return open_name(search, in_folder(name));
}

static FILE *open_in_other_case(struct search *search, const char *name)
{
    return open_in_any_case(search, in_folder(name), &model.other_case);
}

/* What is beside the model and cannot be read is not what the model says. */
static FILE *open_beside(struct search *search, const char *name)
{
    const char *bare = name_bare(name);
    struct error ignored;
    struct search own = *search;
    if (bare == name) return NULL;
    own.err = &ignored;
    FILE *file = open_in_any_case(&own, bare, &model.beside);
    search->is_over = file != NULL;
    return file;
}

FILE *companion_open(const char *name, size_t most_b, size_t *size_b, struct error *err)
{
    static open_form *const ways[] = {open_as_said, open_in_other_case, open_beside};
    struct search search = {.said = name, .most_b = most_b, .size_b = size_b, .err = err};
    struct name_forms forms;
    FILE *file = NULL;
    if (!name_forms_of(name, &forms)) {
        too_long(err);
        return NULL;
    }
    for (size_t way = 0; way < sizeof ways / sizeof *ways; way++)
        for (size_t i = 0; !search.is_over && i < forms.count; i++)
            file = ways[way](&search, forms.forms[i]);
    if (!file && !search.is_over && search.is_outside)
        refuse(name, err);
    else if (!file)
        errno = search.why;
    return file;
}

bool companion_is_there(const char *name)
{
    char path[PATH_SIZE_B];
    struct stat about;
    if (!trusts && leads_out(name)) return false;
    const int length = snprintf(path, sizeof path, "%s%s", *name == '/' ? "" : model.folder, name);
    return length < PATH_SIZE_B && stat(path, &about) == 0;
}

static void tell(struct model *to, const char *what, const struct names *names)
{
    char list[ERROR_B];
    if (names->item_count) model_note(to, "%s: %s", what, names_list(names, list, sizeof list));
}

void companions_tell(struct model *to)
{
    tell(to, "not found where it says, but beside it", &model.beside);
    tell(to, "read by names that differ in capitals", &model.other_case);
    forget_names();
}

void companion_note(const char *name)
{
    struct name_forms forms;
    char path[2 * PATH_SIZE_B];
    for (size_t i = 0; name_forms_of(name, &forms) && i < forms.count; i++) {
        const char *inside = in_folder(forms.forms[i]);
        if (!trusts && leads_out(inside)) continue;
        snprintf(path, sizeof path, "%s%s", *inside == '/' ? "" : model.folder, inside);
        inputs_note_name(path);
    }
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
