/* SPDX-License-Identifier: MIT
 *
 * What host code has to say though nothing is wrong: that a choice was made for the user, or that an option changes
 * nothing. It costs no exit status. */
#ifndef SIM_NOTICE_H
#define SIM_NOTICE_H

/* One line on standard error, after the program's name; printf-style, without a newline. What cannot be shown is
 * replaced (printable.h). */
void notice(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
