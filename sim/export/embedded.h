/* SPDX-License-Identifier: MIT
 *
 * Sources that the program carries in itself, so that it can write a renderer for a scene wherever it is installed.
 * The build writes the table (sim/tools/embed.sh). */
#ifndef SIM_EMBEDDED_H
#define SIM_EMBEDDED_H

struct embedded {
    const char *path; /* in the project: "firmware/view/walk.c" */
    const char *text;
};

/* In the order of their paths; ends with a NULL path. */
extern const struct embedded embedded_files[];

/* NULL: there is no such file. */
const struct embedded *embedded_find(const char *path);

#endif
