/* SPDX-License-Identifier: MIT
 *
 * What a code means, in words for people: the renderer's codes (target.h), a panel's (panel.h), a microcontroller's
 * (mcu/mcu.h), and negative errno. The one table of them; who prints a code calls this. */
#ifndef HAL_LINUX_CODE_WORDS_H
#define HAL_LINUX_CODE_WORDS_H

#include "c_linkage.h"

HAL_C_BEGIN

/* A part of a sentence, "the lens or the eye is out of range"; constant, or strerror()'s. What no table has is "a code
 * that only the port knows": its number is for who wrote the port. */
const char *code_words(int code);

HAL_C_END

#endif
