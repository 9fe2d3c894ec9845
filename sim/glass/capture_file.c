/* SPDX-License-Identifier: MIT
 *
 * A file is told by its first byte that is no blank: VCD's is a dollar sign, a zip archive's a P. */
#include "glass/capture_file.h"

#include "base/progress.h"
#include "glass/sigrok.h"
#include "glass/vcd.h"

#include <ctype.h>

/* More blanks before a capture are no capture's: who sends them may never end. */
enum { BLANKS_MAX = 4096 };

enum capture_kind capture_kind_of(FILE *file, size_t *lines)
{
    int byte;
    for (unsigned blanks = 0; (byte = getc(file)) != EOF && isspace(byte) && blanks < BLANKS_MAX; blanks++)
        *lines += byte == '\n';
    if (byte != EOF) ungetc(byte, file);
    return byte == '$' ? CAPTURE_VCD : byte == 'P' ? CAPTURE_SIGROK : CAPTURE_NONE;
}

bool capture_read(struct capture *capture, enum capture_kind kind, FILE *file, struct error *err)
{
    err->text[0] = '\0';
    const bool ok = kind == CAPTURE_VCD ? vcd_read(capture, file, err) : sigrok_read(capture, err);
    const bool has_ended = ok && capture_end(capture, err);
    progress_end();
    return has_ended || !err->text[0];
}
