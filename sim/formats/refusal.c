/* SPDX-License-Identifier: MIT */
#include "formats/refusal.h"

#include "files/whole_file.h"
#include "model/note_words.h"

#include <stdio.h>
#include <string.h>

#define UNKNOWN "not in a format that the importer knows; glTF, OBJ, PLY, STL and others are: limner formats"

/* What the library says, of files with any name but one that ends so. Whatever nobody else takes is tried as Blender's.
 */
static const struct {
    const char *says, *unless, *words;
} CAUSES[] = {{"bad_alloc", NULL, "it asks for more memory than the importer gets"},
              {"No suitable reader", NULL, UNKNOWN},
              {"BLENDER magic", ".blend", UNKNOWN},
              {"STL storage", ".stl", UNKNOWN},
              {"Ogre Mesh", NULL, UNKNOWN}};

/* But for those that the library unpacks itself. */
static bool is_zip(const char *path)
{
    char head[4] = "";
    if (path_has_suffix(path, ".zae") || path_has_suffix(path, ".pk3")) return false;
    FILE *file = fopen(path, "rb");
    const bool is_read = file && fread(head, sizeof head, 1, file) == 1;
    if (file) fclose(file);
    return is_read && memcmp(head, "PK\003\004", sizeof head) == 0;
}

/* Collada's: the library passes over such meshes, and may then miss others that they refer to. */
static bool has_morphs(const char *path)
{
    struct whole_file file;
    struct error ignored; /* the library has read it */
    if (!path_has_suffix(path, ".dae") || !whole_file_read(path, &file, &ignored)) return false;
    const bool has = strstr(file.bytes, "<morph") != NULL;
    whole_file_free(&file);
    return has;
}

static const char *words_for(const char *path, const char *reason)
{
    const bool has_no_faces = strcmp(reason, WORDS_NO_FACES) == 0;
    if ((has_no_faces || strstr(reason, "library reference")) && has_morphs(path)) return WORDS_NO_MORPHS;
    if (has_no_faces) return reason;
    if (is_zip(path)) return "it is compressed, as a ZIP archive: unpack it, and give what is in it";
    for (size_t i = 0; i < sizeof CAUSES / sizeof *CAUSES; i++)
        if (strstr(reason, CAUSES[i].says) && !(CAUSES[i].unless && path_has_suffix(path, CAUSES[i].unless)))
            return CAUSES[i].words;
    return NULL;
}

bool refusal_set(const char *path, const char *reason, struct error *err)
{
    const char *words = words_for(path, reason);
    size_t length = strlen(reason);
    if (words) return error_set(err, "%s: %s", path, words);
    while (length > 0 && strchr(" .\r\n", reason[length - 1]))
        length--;
    return error_set(err, "%s: %.*s%s", path, (int)length, reason,
                     path_has_suffix(path, ".blend") ? "; export glTF from Blender" : "");
}
