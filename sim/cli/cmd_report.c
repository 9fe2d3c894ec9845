/* SPDX-License-Identifier: MIT
 *
 * `limner report MODEL -o FILE.html`: all that is known of a scene, in one page that loads nothing. The file is whole
 * or not there. */
#include "cli/commands.h"
#include "levels/level_path.h"
#include "outputs/outputs.h"
#include "page/page.h"

#include <stdio.h>
#include <stdlib.h>

/* What cannot be written is told before all the work. */
static bool run(struct page *page, struct outputs *outputs, struct error *err)
{
    const char *path = page->request.folder;
    level_path_note(page->request.model);
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    const bool ok = page_collect(page, err) && page_write(page, file, err);
    return outputs_close(file, path, ok ? err : &(struct error){0}) && ok && outputs_keep(outputs, err);
}

int cmd_report(int argc, char **argv)
{
    struct page *page = calloc(1, sizeof *page); /* rows with counts are large */
    struct outputs outputs = {0};
    struct error err;
    bool ok = page || error_set(&err, "report: out of memory");
    ok = ok && measure_request_parse(argc, argv, MEASURE_PAGE, &page->request, &err) &&
         (page->request.folder || error_set(&err, "report: needs -o FILE.html")) && run(page, &outputs, &err);
    outputs_discard(&outputs);
    if (page) page_free(page);
    free(page);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
