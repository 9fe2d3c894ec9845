/* SPDX-License-Identifier: MIT
 *
 * What a file may be called that a model names: names come from Windows, from URIs, from people who quote. */
#ifndef SIM_NAME_FORMS_H
#define SIM_NAME_FORMS_H

#include <stdbool.h>
#include <stddef.h>

enum { NAME_FORM_B = 4096, NAME_FORMS_MOST = 4 };

/* As it is said; without blanks at its ends and quotes round it; each with %20 as a blank. No two are the same. In all
 * of them \ is /. */
struct name_forms {
    char forms[NAME_FORMS_MOST][NAME_FORM_B];
    size_t count;
};

/* false: the name is too long for a path. */
bool name_forms_of(const char *name, struct name_forms *out);

/* What stands behind the last /. */
const char *name_bare(const char *path);

#endif
