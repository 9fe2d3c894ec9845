/* SPDX-License-Identifier: MIT
 *
 * What is taken out of any command line with models, before the command reads it. */
#include "cli/options.h"
#include "compiler/texture_budget.h"
#include "files/companion.h"
#include "files/picture.h"
#include "levels/level_moves.h"

#include <string.h>

static struct model_options given; /* by the last command line that was taken */

static bool set_sky(const char *material, struct error *err)
{
    (void)err;
    pictures_set_sky(material);
    return true;
}

static bool set_doors(const char *name, struct error *err)
{
    enum level_doors doors;
    if (!level_doors_parse(name, &doors, err)) return false;
    level_doors_set(doors);
    return true;
}

static bool set_textures(const char *name, struct error *err)
{
    if (strcmp(name, "flat") == 0) pictures_take_means();
    return strcmp(name, "flat") == 0 || strcmp(name, "drawn") == 0 ||
           error_set(err, "--textures %s: neither 'drawn' nor 'flat'", name);
}

/* Those with a value. */
static const struct {
    const char *name;
    bool (*set)(const char *value, struct error *err);
} OPTIONS[] = {{"--sky", set_sky},
               {"--textures", set_textures},
               {"--texture-budget", texture_budget_parse},
               {"--doors", set_doors}};
_Static_assert(sizeof OPTIONS / sizeof *OPTIONS + 1 <= MODEL_OPTIONS_MAX, "each is given once");
static const char NO_TEXTURES[] = "--no-textures";
enum { DASHES = 2 };

bool model_options_take(struct arguments *arguments, struct error *err)
{
    given.count = 0;
    if (arguments_flag(arguments, "--trust-paths")) companions_trust();
    if (arguments_flag(arguments, NO_TEXTURES)) {
        pictures_leave_out();
        given.items[given.count++] = (struct model_option){NO_TEXTURES + DASHES, NULL};
    }
    for (size_t i = 0; i < sizeof OPTIONS / sizeof *OPTIONS; i++) {
        const char *value = NULL;
        if (!arguments_value(arguments, OPTIONS[i].name, &value, err)) return false;
        if (!value) continue;
        if (!OPTIONS[i].set(value, err)) return false;
        given.items[given.count++] = (struct model_option){OPTIONS[i].name + DASHES, value};
    }
    return true;
}

const struct model_options *model_options_given(void)
{
    return &given;
}

bool model_options_knows(const char *word)
{
    const size_t length = strcspn(word, "=");
    if (strcmp(word, NO_TEXTURES) == 0) return true;
    for (size_t i = 0; i < sizeof OPTIONS / sizeof *OPTIONS; i++)
        if (word[length] && strlen(OPTIONS[i].name) == length && strncmp(word, OPTIONS[i].name, length) == 0)
            return true;
    return false;
}
