/* SPDX-License-Identifier: MIT
 *
 * Which files a command reads of a model: noted as they are opened, also by the importer's child process. For reports,
 * which pack them, and for the blame when an importer crashes. */
#ifndef SIM_INPUTS_H
#define SIM_INPUTS_H

/* From now on names go to this file descriptor, each with a zero behind it; child processes inherit it. */
void inputs_note_to(int descriptor);

enum { INPUTS_LAST_B = 4096 };

/* From now on the file that was opened last is named here, too; memory that processes share. NULL: nowhere. */
void inputs_last_in(char last[INPUTS_LAST_B]);

/* Notes a file that has been opened. Does nothing unless asked for. */
void inputs_note(const char *path);

#endif
