/* SPDX-License-Identifier: MIT
 *
 * sigrok's session files (.sr), versions 1 and 2: zip archives of which `metadata` says what the channels are, and
 * `logic-1-1`, `logic-1-2` and so on (`logic-1` alone, too) have the samples. Of any size: a block of samples is in
 * memory. */
#ifndef SIM_SIGROK_H
#define SIM_SIGROK_H

#include "glass/capture.h"

/* The file that the capture's path names, which is opened anew, and perhaps more than once. false: an error, with the
 * time where there is one; or, without a text, nothing more is wanted. */
bool sigrok_read(struct capture *capture, struct error *err);

#endif
