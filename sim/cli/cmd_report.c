/* SPDX-License-Identifier: MIT
 *
 * `limner report MODEL -o FILE.html`: all that is known of a scene, in one page that loads nothing. The file is whole
 * or not there. */
#include "base/outputs.h"
#include "cli/commands.h"
#include "page/page.h"

#include <stdio.h>
#include <stdlib.h>

static bool write_page(const struct page *page, struct error *err)
{
    struct outputs outputs = {0};
    const char *path = page->request.folder;
    FILE *file = outputs_spare(&outputs, page->request.model, err) ? outputs_open(&outputs, path, err) : NULL;
    bool ok = file && page_write(page, file, err);
    if (file) ok = outputs_close(file, path, ok ? err : &(struct error){0}) && ok;
    ok = ok && outputs_keep(&outputs, err);
    outputs_discard(&outputs);
    return ok;
}

int cmd_report(int argc, char **argv)
{
    struct page *page = calloc(1, sizeof *page); /* rows with counts are large */
    struct error err;
    bool ok = page || error_set(&err, "report: out of memory");
    ok = ok && measure_request_parse(argc, argv, MEASURE_PAGE, &page->request, &err) &&
         (page->request.folder || error_set(&err, "report: needs -o FILE.html")) && page_collect(page, &err) &&
         write_page(page, &err);
    if (page) page_free(page);
    free(page);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
