/* SPDX-License-Identifier: MIT
 *
 * What the words of a world's templates stand for. */
#ifndef SIM_EXPORT_WORDS_H
#define SIM_EXPORT_WORDS_H

#include "base/error.h"
#include "export/export_plan.h"
#include "export/template.h"

enum { EXPORT_WORDS_MAX = 40 };

struct export_words {
    struct template_word list[EXPORT_WORDS_MAX];
    char *texts[EXPORT_WORDS_MAX]; /* of list[], owned */
    size_t count;
};

bool export_words_init(struct export_words *words, const struct export_plan *plan, struct error *err);
void export_words_free(struct export_words *words);

#endif
