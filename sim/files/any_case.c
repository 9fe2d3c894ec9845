/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "files/any_case.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

struct spelling {
    char path[4096]; /* the folder, then what was found of the name */
    size_t path_b;
};

static bool append(struct spelling *found, const char *text, size_t length)
{
    if (found->path_b + length >= sizeof found->path) return false;
    memcpy(found->path + found->path_b, text, length);
    found->path_b += length;
    found->path[found->path_b] = '\0';
    return true;
}

static bool is_there(const char *path)
{
    struct stat about;
    return lstat(path, &about) == 0;
}

/* The only entry of a folder that a name has but for capitals; "": none, or several. */
static void only_entry(const char *folder, const char *name, size_t length, char out[256])
{
    size_t count = 0;
    DIR *entries = opendir(*folder ? folder : ".");
    out[0] = '\0';
    for (const struct dirent *entry; entries && (entry = readdir(entries));) {
        if (strlen(entry->d_name) != length || strncasecmp(entry->d_name, name, length) != 0) continue;
        snprintf(out, 256, "%s", entry->d_name);
        count++;
    }
    if (entries) closedir(entries);
    if (count != 1) out[0] = '\0';
}

static bool append_step(struct spelling *found, const char *name, size_t length)
{
    char entry[256];
    const size_t before_b = found->path_b;
    if (!append(found, name, length)) return false;
    if (is_there(found->path)) return true;
    found->path[found->path_b = before_b] = '\0';
    only_entry(found->path, name, length, entry);
    return entry[0] && append(found, entry, length);
}

bool any_case_find(const char *folder, const char *name, char *out, size_t out_b)
{
    struct spelling found = {.path_b = 0};
    const size_t folder_b = strlen(folder);
    if (*name == '/' || !*name || !append(&found, folder, folder_b)) return false;
    for (size_t length; *name; name += length) {
        length = strcspn(name, "/");
        if (length && !append_step(&found, name, length)) return false;
        name += length;
        length = *name == '/';
        if (length && !append(&found, "/", 1)) return false;
    }
    return snprintf(out, out_b, "%s", found.path + folder_b) < (int)out_b;
}
