/* SPDX-License-Identifier: MIT
 *
 * Where an exported folder is to be used: Arduino and the others. A world is a list of files, most of them templates of
 * the folder worlds/, in which words between @ are replaced (template.h). */
#ifndef SIM_WORLD_H
#define SIM_WORLD_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* When a file belongs to the folder. */
enum world_when { WORLD_ALWAYS, WORLD_WITH_PANEL, WORLD_WITHOUT_PANEL, WORLD_IN_COLOUR };

struct world_file {
    const char *from; /* in the project */
    const char *to;   /* in the folder; @name@ is replaced here, too */
    enum world_when when;
};

struct world {
    const char *name, *title;
    const char *panel;  /* the commonest display there; NULL: pixels are sent by a function of the user's */
    const char *source; /* folder for sources: "src/" */
    const char *header; /* folder for headers */
    const struct world_file *files;
    size_t file_count;
    uint16_t line_count;     /* of pixels: two where one is sent while another is painted */
    const char *smallest;    /* board; NULL: there is no such */
    uint32_t flash_b, ram_b; /* of that, for a program and its data; RAM with the stack, less what is the world's own */
    bool is_avr;             /* some of its boards are */
};

/* NULL and a list of those that there are. */
const struct world *world_find(const char *name, struct error *err);

#endif
