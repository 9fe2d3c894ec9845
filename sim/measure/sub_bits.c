/* SPDX-License-Identifier: MIT
 *
 * targets/core.sh makes a shared object of firmware/ and core/core.c, as the Makefile makes the profiles' renderers;
 * dlopen() finds its table by name. */
#include "measure/sub_bits.h"

#include "base/child.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef LIM_SOURCE_FOLDER
#error "LIM_SOURCE_FOLDER is set by the Makefile"
#endif

enum { PATH_MAX_B = 1024, SUB_BITS_MOST = 12 /* firmware/config.h */ };

const char *const sub_bits_usual[] = {"fast_4", "fast_5", "fast_8", "fine_6", NULL};

/* The profile that a name begins with, and its bits in plain decimal; NULL: it is no such name. */
static const struct core *profile_of(const char *name, unsigned *bits)
{
    char profile[SUB_BITS_NAME_B], plain[SUB_BITS_NAME_B];
    const char *line = strchr(name, '_');
    if (!line || strlen(name) >= SUB_BITS_NAME_B) return NULL;
    snprintf(profile, sizeof profile, "%.*s", (int)(line - name), name);
    *bits = (unsigned)strtoul(line + 1, NULL, 10);
    snprintf(plain, sizeof plain, "%u", *bits);
    return strcmp(plain, line + 1) == 0 ? core_find(profile) : NULL;
}

bool sub_bits_check_name(const char *name, struct error *err)
{
    unsigned bits;
    const struct core *profile = profile_of(name, &bits);
    if (!profile) return error_set(err, "--precision %s: no such profile, nor one with other sub-pixel bits", name);
    if (bits > SUB_BITS_MOST) return error_set(err, "--precision %s: 0 to %d sub-pixel bits", name, SUB_BITS_MOST);
    if (bits == profile->sub_bits)
        return error_set(err, "--precision %s: these are the bits of %s itself", name, profile->name);
    return true;
}

bool sub_bits_check_tools(struct error *err)
{
    const char *given = getenv("CC"), *compiler = given && *given ? given : "gcc";
    if (access(LIM_SOURCE_FOLDER "/sim/targets/core.sh", R_OK) != 0)
        return error_set(err, "other sub-pixel bits need the source tree that this program is from, %s",
                         LIM_SOURCE_FOLDER);
    return strchr(compiler, ' ') || child_exists(compiler) ||
           error_set(err, "%s: not found; other sub-pixel bits need Debian's package gcc", compiler);
}

static bool build(const char *name, const char *folder, struct error *err)
{
    char log[PATH_MAX_B], task[64];
    const char *const argv[] = {"sh", "sim/targets/core.sh", name, folder, NULL};
    const struct child child = {.argv = argv, .folder = LIM_SOURCE_FOLDER, .log_path = log};
    snprintf(task, sizeof task, "compiling %s", name);
    if (snprintf(log, sizeof log, "%s/log", folder) >= PATH_MAX_B)
        return error_set(err, "%.64s...: the path is too long", folder);
    return child_run(&child, task, err);
}

bool sub_bits_load(const char *name, const char *folder, const struct core **out, struct error *err)
{
    char path[PATH_MAX_B], symbol[SUB_BITS_NAME_B + 8];
    if (!sub_bits_check_name(name, err) || !build(name, folder, err)) return false;
    snprintf(symbol, sizeof symbol, "core_%s", name);
    if (snprintf(path, sizeof path, "%s/core_%s.so", folder, name) >= PATH_MAX_B)
        return error_set(err, "%.64s...: the path is too long", folder);
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    const struct core *core = library ? dlsym(library, symbol) : NULL;
    if (!core) return error_set(err, "%s: %s", name, dlerror());
    *out = core;
    return core->shared_b == CORE_SHARED_B ||
           error_set(err, "%s does not fit this program (is it older than its source tree, %s?)", name,
                     LIM_SOURCE_FOLDER);
}
