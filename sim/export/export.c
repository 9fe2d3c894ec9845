/* SPDX-License-Identifier: MIT
 *
 * Everything is written through one set of outputs, so that a folder is whole or is not there. limner.files says what
 * an export wrote, so that the next one may take its place, and nothing else may be overwritten. */
#include "export/export.h"

#include "agree.h"
#include "base/printable.h"
#include "export/amalgam.h"
#include "export/display_c.h"
#include "export/embedded.h"
#include "export/export_words.h"
#include "export/template.h"
#include "scene/mcu_mem.h"
#include "scene/moving.h"
#include "scene/needs.h"

#include <stdlib.h>
#include <string.h>

/* Nobody else defines these. */
static const char *const SETTLED[] = {"LIM_HAS_",     "LIM_PROFILE", "LIM_SUB_BITS",  "LIM_MAX_",
                                      "LIM_CONFIG",   "LIM_READS_",  "LIM_SETTINGS_", "SCREEN_STREAMS",
                                      "PIXELS_ONLY_", "BOARD_ENDS",  "__has_include", NULL};
static const char *const FOLDERS[] = {"firmware/", "hal/", "boards/common/", NULL};

/* In which order its rooms are joined, the lowest first; then what knows them all. */
static const char *const ROOMS[] = {"math/",  "view/",   "touch/",  "screen/", "pixels/",
                                    "lines/", "movers/", "pieces/", "orders/", ""};
static const char TREE_ROOM[] = "touch/"; /* of scenes with a tree */

/* An estimate, on the safe side of what is told: the smallest renderer with a driver. */
enum { LEAST_CODE_B = 8192 };

static FILE *open_in(const struct export_plan *plan, const char *folder, const char *name, char path[C_PATH_MAX_B],
                     struct outputs *outputs, struct error *err)
{
    if (snprintf(path, C_PATH_MAX_B, "%s/%s%s", plan->folder, folder, name) >= C_PATH_MAX_B) {
        error_set(err, "%s: the path is too long", plan->folder);
        return NULL;
    }
    return outputs_open(outputs, path, err);
}

static void put_settings(const struct export_plan *plan, FILE *out)
{
    const struct needs needs = c_header_needs(plan->scenes, plan->count);
    if (export_is_filled(plan)) fputs("#define LIM_HAS_FILL 1\n#define LIM_HAS_LINES 0\n", out);
    needs_write(&needs, out);
}

/* As text that amalgam.h learns the settings from. */
static bool add_settings(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err)
{
    char *settings = NULL;
    size_t settings_b;
    FILE *memory = open_memstream(&settings, &settings_b);
    if (!memory) return error_set(err, "no memory for settings");
    put_settings(plan, memory);
    fclose(memory);
    const bool ok = amalgam_add_text(joined, "what the scene requires", settings, out, err);
    free(settings);
    return ok;
}

static bool has_tree(const struct export_plan *plan)
{
    bool has = false;
    for (size_t i = 0; i < plan->count; i++)
        has = has || plan->scenes[i].scene->scene.node_count > 0;
    return has;
}

static bool write_header(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err)
{
    fprintf(out,
            "/* Limner %d.%d.%d: solid 3D scenes on small displays. The renderer for %s, written by `limner export`.\n"
            " * MIT licence: see LICENSE. */\n#ifndef LIMNER_H\n#define LIMNER_H\n",
            LIM_VERSION_MAJOR, LIM_VERSION_MINOR, LIM_VERSION_PATCH, plan->name->symbol);
    if (!add_settings(plan, joined, out, err) || !amalgam_add(joined, "firmware/limner.h", out, err)) return false;
    if (conditions_ask(&joined->conditions, "LIM_HAS_OVERLAY") == KNOWN_TRUE &&
        (!amalgam_add(joined, "firmware/overlay.h", out, err) || !amalgam_add(joined, "firmware/text.h", out, err)))
        return false;
    if (has_tree(plan) && !amalgam_add(joined, "firmware/collide.h", out, err)) return false;
    fputs("\n#endif\n", out);
    return true;
}

static bool add_room(const char *room, struct amalgam *joined, FILE *out, struct error *err)
{
    char start[64];
    const size_t start_b = (size_t)snprintf(start, sizeof start, "firmware/%s", room);
    for (const struct embedded *file = embedded_files; file->path; file++) {
        const size_t path_b = strlen(file->path);
        if (strncmp(file->path, start, start_b) != 0 || strchr(file->path + start_b, '/')) continue;
        if (strcmp(file->path + path_b - 2, ".c") == 0 && !amalgam_add(joined, file->path, out, err)) return false;
    }
    return true;
}

static bool write_renderer(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err)
{
    fputs("/* The renderer whose header is limner.h; written by `limner export` from the files that are named below. "
          "MIT\n"
          " * licence: see LICENSE. */\n#include \"limner.h\"\n",
          out);
    fputs(EXPORT_UNUSED, out);
    for (size_t i = 0; i < sizeof ROOMS / sizeof *ROOMS; i++)
        if ((has_tree(plan) || strcmp(ROOMS[i], TREE_ROOM) != 0) && !add_room(ROOMS[i], joined, out, err)) return false;
    return true;
}

/* limner.h, and then whatever rests upon it. */
typedef bool part_writer(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err);

static bool put_part(const struct export_plan *plan, const char *folder, const char *name, part_writer *write,
                     struct amalgam *joined, struct outputs *outputs, struct error *err)
{
    char path[C_PATH_MAX_B];
    FILE *out = open_in(plan, folder, name, path, outputs, err);
    if (!out) return false;
    const bool ok = write(plan, joined, out, err);
    return outputs_close(out, path, err) && ok;
}

static bool renderer_part(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err)
{
    return write_renderer(plan, joined, out, err);
}

static bool display_header_part(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err)
{
    (void)joined;
    return display_c_write_header(plan, out, err);
}

/* What a port fills. */
static bool add_wires(struct amalgam *joined, FILE *out, struct error *err)
{
    return amalgam_add(joined, "hal/spi_modes.h", out, err) && amalgam_add(joined, "boards/common/board.h", out, err);
}

/* It stands alone; *joined learns what is in it. */
static bool wires_part(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err)
{
    struct amalgam alone = {.conditions.settled = SETTLED, .folders = FOLDERS};
    (void)plan;
    fputs(
        "/* What a display hangs on: bus, pins and clock, which a port fills. Written by `limner export`. MIT licence: "
        "see\n * LICENSE. */\n#ifndef LIMNER_DISPLAY_H\n#define LIMNER_DISPLAY_H\n",
        out);
    FILE *nowhere = fopen("/dev/null", "w");
    const bool ok = add_wires(&alone, out, err) &&
                    (nowhere ? add_wires(joined, nowhere, err) : error_set(err, "/dev/null: cannot be opened"));
    if (nowhere) fclose(nowhere);
    amalgam_free(&alone);
    fputs("\n#endif\n", out);
    return ok;
}

static bool put_display(const struct export_plan *plan, struct amalgam *joined, struct outputs *outputs,
                        struct error *err)
{
    char header[C_NAME_MAX_B + 16], source[C_NAME_MAX_B + 16];
    snprintf(header, sizeof header, "%s_display.h", plan->name->symbol);
    snprintf(source, sizeof source, "%s_display.c", plan->name->symbol);
    return put_part(plan, plan->world->header, "limner_display.h", wires_part, joined, outputs, err) &&
           put_part(plan, plan->world->header, header, display_header_part, joined, outputs, err) &&
           put_part(plan, plan->world->source, source, display_c_write_source, joined, outputs, err);
}

/* Two branches of one header: the renderer and the display's driver each join what limner.h did not. */
static bool put_sources(const struct export_plan *plan, struct outputs *outputs, struct error *err)
{
    struct amalgam renderer = {.conditions.settled = SETTLED, .folders = FOLDERS};
    struct amalgam display = renderer;
    bool ok = put_part(plan, plan->world->header, "limner.h", write_header, &renderer, outputs, err) &&
              put_part(plan, plan->world->source, "limner.c", renderer_part, &renderer, outputs, err);
    FILE *nowhere = fopen("/dev/null", "w");
    ok = ok && (nowhere || error_set(err, "/dev/null: cannot be opened")) &&
         (!plan->module || (write_header(plan, &display, nowhere, err) && put_display(plan, &display, outputs, err)));
    if (nowhere) fclose(nowhere);
    amalgam_free(&renderer);
    amalgam_free(&display);
    return ok;
}

static bool is_wanted(const struct export_plan *plan, enum world_when when)
{
    switch (when) {
    case WORLD_ALWAYS:
        return true;
    case WORLD_WITH_PANEL:
        return plan->module;
    case WORLD_WITHOUT_PANEL:
        return !plan->module;
    default:
        return export_is_in_colour(plan);
    }
}

/* Headers of the project, as adapters name them. */
static bool is_own_include(const char *line)
{
    static const char *const own[] = {"limner.h", "target.h", "board.h", "bus.h", "spi_modes.h"};
    if (strncmp(line, "#include \"", 10) != 0) return false;
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (strncmp(line + 10, own[i], strlen(own[i])) == 0 && line[10 + strlen(own[i])] == '"') return true;
    return false;
}

/* Files of the project that come as they are: one header takes the place of those that it was joined from. */
static void write_adapter(const char *text, const char *header, FILE *out)
{
    bool is_included = false;
    for (const char *end; *text; text = end) {
        end = strchr(text, '\n');
        end = end ? end + 1 : text + strlen(text);
        if (!is_own_include(text)) {
            fwrite(text, 1, (size_t)(end - text), out);
        } else if (!is_included) {
            fprintf(out, "#include \"%s\"\n", header);
            is_included = true;
        }
    }
}

static bool is_adapter(const char *from)
{
    return strncmp(from, "hal/adapters/", 13) == 0;
}

/* Ports know the display's wires, others the renderer. */
static const char *adapter_header(const char *text)
{
    return strstr(text, "#include \"limner.h\"") ? "limner.h" : "limner_display.h";
}

static bool put_file(const struct export_plan *plan, const struct world_file *file, const struct template_word *words,
                     size_t word_count, struct outputs *outputs, struct error *err)
{
    char *to = NULL, path[C_PATH_MAX_B];
    size_t to_b;
    const struct embedded *from = embedded_find(file->from);
    if (!from) return error_set(err, "%s: no such file in this program", file->from);
    FILE *memory = open_memstream(&to, &to_b);
    if (!memory) return error_set(err, "no memory for a name");
    template_write(memory, file->to, words, word_count);
    fclose(memory);
    FILE *out = open_in(plan, "", to, path, outputs, err);
    free(to);
    if (!out) return false;
    if (is_adapter(file->from))
        write_adapter(from->text, adapter_header(from->text), out);
    else
        template_write(out, from->text, words, word_count);
    return outputs_close(out, path, err);
}

static bool put_world(const struct export_plan *plan, const struct template_word *words, size_t word_count,
                      struct outputs *outputs, struct error *err)
{
    static const struct world_file licence = {"LICENSE", "LICENSE", WORLD_ALWAYS};
    if (!put_file(plan, &licence, words, word_count, outputs, err)) return false;
    for (size_t i = 0; i < plan->world->file_count; i++) {
        const struct world_file *file = &plan->world->files[i];
        if (is_wanted(plan, file->when) && !put_file(plan, file, words, word_count, outputs, err)) return false;
    }
    return true;
}

static bool put_scenes(const struct export_plan *plan, struct outputs *outputs, struct error *err)
{
    char header[C_PATH_MAX_B];
    if (snprintf(header, sizeof header, "%s/%s%s", plan->folder, plan->world->header, plan->name->symbol) >=
        C_PATH_MAX_B)
        return error_set(err, "%s: the path is too long", plan->folder);
    if (!c_declarations_put(plan->scenes, plan->count, header, outputs, err)) return false;
    for (size_t i = 0; i < plan->count; i++) {
        const struct named_scene *scene = &plan->scenes[i];
        if (!c_source_put(scene, header, outputs, err) || (scene->moving && !c_movers_put(scene, header, outputs, err)))
            return false;
    }
    return true;
}

bool export_put(const struct export_plan *plan, struct outputs *outputs, struct error *err)
{
    struct export_words words;
    if (!export_words_init(&words, plan, err)) return false;
    const bool ok = put_scenes(plan, outputs, err) && put_sources(plan, outputs, err) &&
                    put_world(plan, words.list, words.count, outputs, err);
    export_words_free(&words);
    return ok;
}

void export_report(const struct export_plan *plan)
{
    const struct world *world = plan->world;
    const struct export_cost cost = export_cost(plan);
    printable_print(stdout,
                    "%s: %zu bytes of scene data, %zu of RAM without the stack; the renderer's code comes on top\n",
                    plan->folder, cost.data_b, cost.ram_b);
    if (!world->smallest || (cost.data_b + LEAST_CODE_B <= world->flash_b && export_has_room(plan, cost.least_ram_b)))
        return;
    printable_print(
        stderr,
        "limner: note: %s is too large for %s, which other boards are not: at least %zu of %lu bytes of flash, %zu of "
        "%lu of RAM\n",
        plan->folder, world->smallest, cost.data_b + LEAST_CODE_B, (unsigned long)world->flash_b,
        cost.least_ram_b + EXPORT_STACK_B, (unsigned long)world->ram_b);
}
