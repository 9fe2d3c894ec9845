/* SPDX-License-Identifier: MIT
 *
 * The example draws the orbit that the simulator has. */
#include "export/export_words.h"

#include "agree.h"
#include "base/grow.h"
#include "cameras/camera_path.h"
#include "scene/moving.h"
#include "scene/needs.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { ORBIT_FRAMES = 36 };

static const double PI = 3.14159265358979323846;

struct export_orbit {
    double target_m[3], radius_m, elevation_deg, near_m, fov_deg;
};

static bool plan_orbit(const struct export_plan *plan, struct export_orbit *orbit, struct error *err)
{
    struct lens lens;
    struct camera_path path;
    const struct compiled *scene = plan->scenes[0].scene;
    if (!lens_for_grid(&lens, LENS_USUAL, plan->near_m, &scene->grid, plan->w_px, plan->h_px, err) ||
        !camera_path_orbit(scene, &lens, ORBIT_FRAMES, &path, err))
        return false;
    const struct viewpoint *first = &path.frames[0];
    double square_m2 = 0.0;
    for (int i = 0; i < 3; i++) {
        orbit->target_m[i] = first->target_m[i];
        square_m2 += (first->eye_m[i] - first->target_m[i]) * (first->eye_m[i] - first->target_m[i]);
    }
    orbit->radius_m = sqrt(square_m2);
    orbit->elevation_deg = asin((first->eye_m[1] - first->target_m[1]) / orbit->radius_m) * 180.0 / PI;
    orbit->near_m = lens.near_m;
    orbit->fov_deg = lens_usual_fov_deg(plan->w_px, plan->h_px);
    camera_path_free(&path);
    return true;
}

/* All sources but the example's, each after a blank and with its folder. */
static void write_sources(const struct export_plan *plan, FILE *out)
{
    const char *folder = plan->world->source, *symbol = plan->name->symbol;
    fprintf(out, "%slimner.c", folder);
    for (size_t i = 0; i < plan->count; i++) {
        const struct moving *moving = plan->scenes[i].moving;
        const char *scene = strrchr(plan->scenes[i].name, '/') + 1;
        fprintf(out, " %s%s.c", folder, scene);
        for (size_t k = 0; moving && k < moving->count; k++)
            fprintf(out, " %s%s_object%zu.c", folder, scene, k + 1);
        if (moving) fprintf(out, " %s%s_movers.c", folder, scene);
    }
    if (plan->module) fprintf(out, " %s%s_display.c", folder, symbol);
}

__attribute__((format(printf, 3, 4))) static void add_word(struct export_words *words, const char *word,
                                                           const char *format, ...)
{
    va_list values, again;
    va_start(values, format);
    va_copy(again, values);
    const size_t text_b = (size_t)vsnprintf(NULL, 0, format, values) + 1;
    char *text = grow_zeroed(text_b, 1);
    vsnprintf(text, text_b, format, again);
    va_end(again);
    va_end(values);
    words->texts[words->count] = text;
    words->list[words->count++] = (struct template_word){word, text};
}

static bool add_sources(const struct export_plan *plan, struct export_words *words, struct error *err)
{
    char *sources = NULL;
    size_t sources_b;
    FILE *memory = open_memstream(&sources, &sources_b);
    if (!memory) return error_set(err, "no memory for the names of sources");
    write_sources(plan, memory);
    fclose(memory);
    add_word(words, "sources", "%s", sources);
    free(sources);
    return true;
}

/* Orbits of long scenes are in whole units, which 32 bits hold. */
static void add_orbit(const struct export_orbit *orbit, bool is_long, struct export_words *words)
{
    add_word(words, "orbit", "%s", is_long ? "lim_orbit_far" : "lim_orbit");
    add_word(words, "target", "%s", is_long ? "target" : "target_q8");
    add_word(words, "POINT", "%s", is_long ? "POINT" : "POINT_Q8");
    add_word(words, "LENGTH", "%s", is_long ? "UNITS" : "M_Q8");
    add_word(words, "TARGET_M", "%.9g, %.9g, %.9g", orbit->target_m[0], orbit->target_m[1], orbit->target_m[2]);
    add_word(words, "ORBIT_M", "%.6g", orbit->radius_m);
    add_word(words, "PITCH", "%.0f", -orbit->elevation_deg);
    add_word(words, "NEAR_M", "%.3g", orbit->near_m);
    add_word(words, "LENS", "%.4g", orbit->fov_deg);
}

/* Who sets chip select: the port, or the display's driver. */
static void add_selects(const struct export_plan *plan, struct export_words *words)
{
    const bool selects = plan->module && plan->module->panel.family->selects;
    add_word(words, "cs_10", "%s", selects ? "LIMNER_NO_PIN" : "10");
    add_word(words, "select_10", "%s", selects ? "10" : "LIMNER_NO_PIN");
    add_word(words, "cs_idf", "%s", selects ? "GPIO_NUM_NC" : "PIN_CS");
    add_word(words, "select_idf", "%s", selects ? "PIN_CS" : "GPIO_NUM_NC");
    add_word(words, "cs_17", "%s", selects ? "LIMNER_NO_PIN" : "17");
    add_word(words, "select_17", "%s", selects ? "17" : "LIMNER_NO_PIN");
}

/* How another scene than the first is shown, if there are more. */
static void add_several(const struct export_plan *plan, struct export_words *words)
{
    struct c_name second;
    struct error ignored;
    if (plan->count < 2 || !c_name_init(&second, plan->scenes[1].name, &ignored))
        add_word(words, "several", "%s", "");
    else if (plan->module)
        add_word(words, "several", "`%s_display_show()` shows the second one, and so on.", second.symbol);
    else
        add_word(words, "several",
                 "`%s_MEMORY()` has room for any of them: `%s_begin()` shows the second one in it, and so on.",
                 plan->name->macro, second.symbol);
}

/* What lines of templates depend on. */
static void add_conditions(const struct export_plan *plan, struct export_words *words)
{
    const struct needs needs = c_header_needs(plan->scenes, plan->count);
    add_word(words, "has_panel", "%s", plan->module ? "1" : "");
    add_word(words, "in_colour", "%s", export_is_in_colour(plan) ? "1" : "");
    add_word(words, "moves", "%s", plan->scenes[0].moving ? "1" : "");
    add_several(plan, words);
    add_word(words, "shown", "%s", plan->scenes[0].moving ? "the scene that stands still" : "the scene");
    add_word(words, "smooth", "%s", needs.antialias ? "1" : "");
    add_word(words, "outlines", "%s", needs.wireframe ? "1" : "");
    add_word(words, "round", "%s", needs.round ? "1" : "");
}

bool export_words_init(struct export_words *words, const struct export_plan *plan, struct error *err)
{
    struct export_orbit orbit;
    struct c_name first;
    const struct export_cost cost = export_cost(plan);
    if (!plan_orbit(plan, &orbit, err) || !c_name_init(&first, plan->scenes[0].name, err)) return false;
    *words = (struct export_words){.count = 0};
    add_word(words, "name", "%s", plan->name->symbol);
    add_word(words, "folder", "%s", strrchr(plan->folder, '/') ? strrchr(plan->folder, '/') + 1 : plan->folder);
    add_word(words, "NAME", "%s", plan->name->macro);
    add_word(words, "scene", "%s", first.symbol);
    add_word(words, "SCENE", "%s", first.macro);
    add_word(words, "title", "%s", plan->world->title);
    add_word(words, "version", "%d.%d.%d", LIM_VERSION_MAJOR, LIM_VERSION_MINOR, LIM_VERSION_PATCH);
    add_word(words, "command", "%s", plan->command);
    add_word(words, "W", "%u", plan->w_px);
    add_word(words, "H", "%u", plan->h_px);
    add_word(words, "panel", "%s", plan->module ? plan->module->panel.name : "no display");
    add_word(words, "data_b", "%zu", cost.data_b);
    add_word(words, "ram_b", "%zu", cost.ram_b);
    add_conditions(plan, words);
    add_selects(plan, words);
    add_orbit(&orbit, plan->scenes[0].scene->grid.is_long, words);
    if (add_sources(plan, words, err)) return true;
    export_words_free(words);
    return false;
}

void export_words_free(struct export_words *words)
{
    for (size_t i = 0; i < words->count; i++)
        free(words->texts[i]);
    *words = (struct export_words){.count = 0};
}
