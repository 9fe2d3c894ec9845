/* SPDX-License-Identifier: MIT
 *
 * What a process may do that reads a file of others by a library: a flaw in it is not to have the user's rights. */
#ifndef SIM_CONFINE_H
#define SIM_CONFINE_H

/* From here on the process can read files, and write to those that it has open; as far as the kernel lets it be said it
 * can open none to write, make, move or remove none, run no program, open no TCP connection and signal no other
 * process. For good. A kernel or a container that does not know how to does without. */
void confine_to_reading(void);

#endif
