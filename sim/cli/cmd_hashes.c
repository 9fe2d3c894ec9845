/* SPDX-License-Identifier: MIT
 *
 * `limner hashes`: pictures of frames that others' displays showed -> hashes as `limner render --write-hashes` has
 * them. With --shrink N every pixel is a square of N by N, as emulators enlarge them: a square of two colours is an
 * error. */
#include "base/inputs.h"
#include "base/parse.h"
#include "base/printable.h"
#include "cli/commands.h"
#include "pictures/enlarged.h"
#include "pictures/hash_list.h"
#include "pictures/image.h"

#include <inttypes.h>
#include <stdlib.h>

enum { SHRINK_MAX = 16 };

static bool add_picture(struct hash_list *list, const char *path, int side, struct error *err)
{
    uint64_t hash = 0;
    gdImagePtr image = image_read_png(path, err);
    if (!image) return false;
    const bool ok = enlarged_hash(image, side, path, &hash, err);
    gdImageDestroy(image);
    if (!ok) return false;
    printable_print(stdout, "frame %zu: hash %016" PRIx64 " of %s\n", list->count, hash, path);
    hash_list_add(list, hash);
    return true;
}

static bool hashes_run(struct arguments *arguments, struct hash_list *list, struct outputs *outputs, struct error *err)
{
    const char *text = NULL;
    uint32_t side = 1;
    if (!hash_list_parse(list, arguments, err) || !arguments_value(arguments, "--shrink", &text, err)) return false;
    if (text && !parse_whole("--shrink", text, 1, SHRINK_MAX, &side, err)) return false;
    if (arguments->count == 1) return error_set(err, "hashes: needs pictures, PNG files");
    for (int i = 1; i < arguments->count; i++)
        inputs_note_name(arguments->items[i]);
    if (!hash_list_open(list, outputs, err)) return false;
    for (int i = 1; i < arguments->count; i++)
        if (!add_picture(list, arguments->items[i], (int)side, err)) return false;
    return hash_list_close(list, err) && outputs_keep(outputs, err) && hash_list_check(list, err);
}

int cmd_hashes(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    struct hash_list list = {0};
    struct outputs outputs = {0};
    struct error err;
    const bool ok = hashes_run(&arguments, &list, &outputs, &err);
    hash_list_free(&list);
    outputs_discard(&outputs);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
