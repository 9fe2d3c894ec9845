/* SPDX-License-Identifier: MIT
 *
 * Files that are called as a model says but for capitals: on the system that wrote it they are the same. */
#ifndef SIM_ANY_CASE_H
#define SIM_ANY_CASE_H

#include <stdbool.h>
#include <stddef.h>

/* The name, below a folder (empty, or with its slash), as the files there spell it. false: there is none, or several
 * that differ in capitals alone, or the name is not relative. */
bool any_case_find(const char *folder, const char *name, char *out, size_t out_b);

#endif
