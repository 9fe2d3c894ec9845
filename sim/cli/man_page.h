/* SPDX-License-Identifier: MIT
 *
 * limner(1), of the same table as the help. */
#ifndef SIM_CLI_MAN_PAGE_H
#define SIM_CLI_MAN_PAGE_H

#include <stdio.h>

/* In the macros of man(7). */
void man_page_print(FILE *out);

#endif
