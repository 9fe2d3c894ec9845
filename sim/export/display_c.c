/* SPDX-License-Identifier: MIT
 *
 * Both files are written with conditions of the project's own sources, which amalgam.h decides. */
#include "export/display_c.h"

#include "cameras/camera_path.h"
#include "displays/idle_port.h"
#include "displays/module_c.h"
#include "scene/moving.h"
#include "scene/needs.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

static const double PI = 3.14159265358979323846, Q28 = 268435456.0;

static bool is_turned(const struct display *display)
{
    return display->camera_turn == PANEL_TURNED_90 || display->camera_turn == PANEL_TURNED_270;
}

static bool scene_name(const struct export_plan *plan, size_t i, struct c_name *name, struct error *err)
{
    return c_name_init(name, plan->scenes[i].name, err);
}

static void write_head(const struct export_plan *plan, FILE *out)
{
    const struct c_name *name = plan->name;
    fprintf(out, "/* %s on %s, with the memory that both take; written by `limner export`.\n *\n", name->symbol,
            plan->module->panel.name);
    fputs(" *     a port fills a struct board (limner_display.h): the bus and the pins that the display hangs on\n",
          out);
    fprintf(out, " *     int err = %s_display_begin(&board);\n", name->symbol);
    fprintf(out, " *     if (!err) err = %s_display_frame(&camera, time_ms);\n", name->symbol);
    fputs(" *\n * 0 is success. Negative: a display's code (enum panel_error), an enum lim_error, or the port's own. "
          "*/\n",
          out);
    fprintf(out, "#ifndef %s_DISPLAY_H\n#define %s_DISPLAY_H\n\n", name->macro, name->macro);
    fprintf(out, "#include \"%s.h\"\n#include \"limner_display.h\"\n\nLIM_C_BEGIN\n\n", name->symbol);
}

static void write_sizes(const struct export_plan *plan, const struct display *display, FILE *out)
{
    const char *macro = plan->name->macro;
    const uint16_t sides_px[2] = {display->panel->w_px, display->panel->h_px};
    const unsigned w_px = sides_px[is_turned(display)], h_px = sides_px[!is_turned(display)];
    fputs("/* Of the picture. */\n", out);
    fprintf(out, "#define %s_DISPLAY_W_PX %u\n", macro, w_px);
    fprintf(out, "#define %s_DISPLAY_H_PX %u\n", macro, h_px);
    fputs("/* What its SPI may run at, and in which modes, 1 << mode each (spi_modes). */\n", out);
    fprintf(out, "#define %s_DISPLAY_HZ UINT32_C(%" PRIu32 ")\n", macro, plan->module->speed_hz);
    fprintf(out, "#define %s_DISPLAY_SPI_MODES %u\n", macro, (unsigned)plan->module->spi_modes);
    const double fov_deg = lens_usual_fov_deg(w_px, h_px);
    fprintf(
        out,
        "/* A lens of %.4g degrees from top to bottom, for struct lim_camera; lim_camera_set_fov() makes others. */\n",
        fov_deg);
    const double tan_y = tan(fov_deg / 360.0 * PI), tan_x = tan_y * w_px / h_px;
    fprintf(out, "#define %s_DISPLAY_TAN_X_Q28 UINT32_C(%.0f)\n", macro, tan_x * Q28);
    fprintf(out, "#define %s_DISPLAY_TAN_Y_Q28 UINT32_C(%.0f)\n\n", macro, tan_y * Q28);
}

bool display_c_write_header(const struct export_plan *plan, FILE *out, struct error *err)
{
    struct display display;
    const char *symbol = plan->name->symbol;
    if (!idle_display_setup(&display, plan->module, err)) return false;
    write_head(plan, out);
    write_sizes(plan, &display, out);
    fprintf(out,
            "/* Starts the display, and then the %sscene on it. The board must outlive it. May be called again when\n"
            " * something failed. */\n",
            plan->count > 1 ? "first " : "");
    fprintf(out, "LIM_MUST_CHECK int %s_display_begin(const struct board *board);\n\n", symbol);
    if (plan->count > 1) fputs("/* From the next frame on. They share their memory. */\n", out);
    for (size_t i = 0; plan->count > 1 && i < plan->count; i++) {
        struct c_name name;
        if (!scene_name(plan, i, &name, err)) return false;
        fprintf(out, "LIM_MUST_CHECK int %s_display_show(void);\n", name.symbol);
    }
    fputs("/* Draws a frame, and returns when the display has it. time_ms places what moves. */\n", out);
    fprintf(out, "LIM_MUST_CHECK int %s_display_frame(const struct lim_camera *camera, uint32_t time_ms);\n\n", symbol);
    fprintf(out,
            "/* While no frames are drawn, once a second at least: what some glass needs to last. */\n"
            "LIM_MUST_CHECK int %s_display_keep(void);\n\n",
            symbol);
    fprintf(out,
            "/* The renderer, for lim_set_...(), once the display has begun. */\nstruct lim "
            "*%s_display_renderer(void);\n\n",
            symbol);
    fputs("LIM_C_END\n\n#endif\n", out);
    return true;
}

/* The most movers of any scene. */
static size_t most_movers(const struct export_plan *plan)
{
    size_t most = 0;
    for (size_t i = 0; i < plan->count; i++)
        if (plan->scenes[i].moving && plan->scenes[i].moving->count > most) most = plan->scenes[i].moving->count;
    return most;
}

/* Where the smallest board has room for the least alone it gets no more than that. */
static void write_pools(const struct export_plan *plan, FILE *out)
{
    const struct export_cost cost = export_cost(plan);
    const char *macro = plan->name->macro;
    if (plan->world->is_avr && !export_has_room(plan, cost.ram_b) && export_has_room(plan, cost.least_ram_b))
        fprintf(out,
                "/* With the least memory the same frames take longer. */\n#if defined(__AVR__)\n#define POOLS_B %zu\n"
                "#else\n#define POOLS_B %s_SCENE_MEM_B(MODULE_H_PX)\n#endif\n",
                cost.least_mem_b, macro);
    else
        fprintf(out, "#define POOLS_B %s_SCENE_MEM_B(MODULE_H_PX)\n", macro);
}

static void write_lines(const struct export_plan *plan, FILE *out)
{
    const char *macro = plan->name->macro;
    if (export_is_filled(plan)) {
        fputs("/* Runs go into the display's pages at once. */\n#define LINES 0\n", out);
        return;
    }
    fprintf(out,
            "/* Of pixels: one is painted while another is sent, or all of them. */\n"
            "#define USED_LINES SCREEN_USED_LINES(MODULE_FORMAT, MODULE_W_PX, MODULE_ROUND, %u)\n",
            plan->world->line_count);
    fprintf(out,
            "#define LINES (%s_SCENE_LINES(MODULE_H_PX) > USED_LINES ? %s_SCENE_LINES(MODULE_H_PX) : USED_LINES)\n",
            macro, macro);
}

static void write_memory(const struct export_plan *plan, FILE *out)
{
    const char *macro = plan->name->macro;
    const size_t movers = most_movers(plan);
    write_lines(plan, out);
    write_pools(plan, out);
    fputs("\nstatic struct screen screen;\nstatic struct lim lim;\nstatic void *pools[LIM_POINTERS(POOLS_B)];\n", out);
    fputs("static uint32_t lines[MODULE_LINES_MEM_B(LINES) / 4];\n", out);
    fputs(
        "#if SCREEN_KEEPS_FRAME\nstatic uint32_t picture[SCREEN_FRAME_MEM_B(MODULE_W_PX, MODULE_H_PX) / 4];\n#endif\n",
        out);
    fprintf(out,
            "#if LIM_HAS_DELTA\nstatic void *delta_mem[LIM_POINTERS(%s_SCENE_DELTA_MEM_B(MODULE_W_PX, "
            "MODULE_H_PX))];\n#endif\n",
            macro);
    fputs("#if LIM_HAS_ANTIALIAS\nstatic uint32_t smooth_mem[LIM_ANTIALIAS_MEM_B(MODULE_W_PX) / 4];\n#endif\n", out);
    if (!movers) return;
    fprintf(out, "static void *mover_mem[LIM_POINTERS(%s_MOVERS_MEM_B)];\n", macro);
    fprintf(out, "static struct lim_instance instances[%zu];\n", movers);
    fputs("static const struct lim_moved *moved; /* NULL: nothing moves */\nstatic uint16_t moved_count;\n", out);
}

static void write_movers(const struct named_scene *scene, const struct c_name *name, FILE *out)
{
    fprintf(out, "    const struct lim_movers_limits limits = %s_MOVERS_LIMITS;\n", name->macro);
    if (scene->moving->light.on) fprintf(out, "    const struct lim_light light = %s_LIGHT;\n", name->macro);
    fprintf(out, "    moved = %s_movers;\n    moved_count = %s_MOVERS;\n", name->symbol, name->macro);
    fputs("    if (!err) err = lim_movers_init(&lim, mover_mem, sizeof mover_mem, &limits);\n", out);
    if (scene->moving->light.on) fputs("    if (!err) lim_light_set(&lim, &light);\n", out);
}

static bool write_show(const struct export_plan *plan, size_t i, FILE *out, struct error *err)
{
    const struct named_scene *scene = &plan->scenes[i];
    struct c_name name;
    if (!scene_name(plan, i, &name, err)) return false;
    fprintf(out, "\n%sint %s_display_show(void)\n{\n", plan->count > 1 ? "" : "static ", name.symbol);
    fprintf(out, "    int err = start(&%s_scene, %s_SCENE_METHOD);\n", name.symbol, name.macro);
    if (scene->moving)
        write_movers(scene, &name, out);
    else if (most_movers(plan))
        fputs("    moved = NULL;\n", out);
    fputs("    return err;\n}\n", out);
    return true;
}

/* What all scenes have in common. */
static const char START[] =
    "\nstatic int start(const struct lim_scene *scene, enum lim_method method)\n"
    "{\n"
    "#if LIM_HAS_FRAMEBUFFER\n"
    "    int err = screen_init_framebuffer(&screen, screen.panel, method, lines, sizeof lines);\n"
    "#else\n"
    "    int err = screen_init(&screen, screen.panel, method, lines, sizeof lines);\n"
    "#endif\n"
    "#if SCREEN_KEEPS_FRAME\n"
    "    if (!err) err = screen_set_frame(&screen, picture, sizeof picture);\n"
    "#endif\n"
    "    if (!err) err = lim_init(&lim, scene, &screen.target, pools, sizeof pools);\n"
    "#if LIM_HAS_DELTA\n"
    "    if (!err) err = lim_set_delta(&lim, delta_mem, sizeof delta_mem);\n"
    "#endif\n"
    "#if LIM_HAS_ANTIALIAS\n"
    "    if (!err) err = lim_set_antialias(&lim, smooth_mem, sizeof smooth_mem);\n"
    "#endif\n"
    "#if LIM_HAS_WIREFRAME\n"
    "    if (!err) lim_set_wireframe(&lim, &(const struct lim_wireframe)MODULE_OUTLINES);\n"
    "#endif\n"
    "    return err;\n"
    "}\n";

static const char STILL_FRAME[] = "    (void)time_ms;\n    if (!err) err = lim_frame(&lim, &turned);\n";

static const char MOVING_FRAME[] =
    "    if (moved) lim_moved_at(moved, moved_count, time_ms, instances);\n"
    "    if (!err) err = moved ? lim_movers_frame(&lim, &turned, instances, moved_count) : lim_frame(&lim, &turned);\n";

static bool write_calls(const struct export_plan *plan, FILE *out, struct error *err)
{
    struct c_name first;
    if (!scene_name(plan, 0, &first, err)) return false;
    fprintf(out,
            "\nint %s_display_begin(const struct board *board)\n{\n    struct panel *panel;\n"
            "    int err = module_setup(&panel, board);\n    if (!err) err = panel_init(panel);\n"
            "    screen.panel = panel;\n    return err ? err : %s_display_show();\n}\n",
            plan->name->symbol, first.symbol);
    fprintf(out,
            "\nint %s_display_frame(const struct lim_camera *camera, uint32_t time_ms)\n{\n"
            "    struct lim_camera turned = *camera;\n    int err = screen_begin_frame(&screen);\n"
            "    screen_turn_camera(&turned, MODULE_CAMERA_TURN);\n",
            plan->name->symbol);
    fputs(most_movers(plan) ? MOVING_FRAME : STILL_FRAME, out);
    fputs("    return err ? err : screen_end_frame(&screen);\n}\n", out);
    fprintf(out, "\nint %s_display_keep(void)\n{\n    return panel_keep(screen.panel);\n}\n", plan->name->symbol);
    fprintf(out, "\nstruct lim *%s_display_renderer(void)\n{\n    return &lim;\n}\n", plan->name->symbol);
    return true;
}

static bool write_glue(const struct export_plan *plan, FILE *out, struct error *err)
{
    write_memory(plan, out);
    fputs(START, out);
    for (size_t i = 0; i < plan->count; i++)
        if (!write_show(plan, i, out, err)) return false;
    return write_calls(plan, out, err);
}

/* The module's two files as texts, to be freed. */
static bool module_texts(const struct module_choice *module, char *texts[2], struct error *err)
{
    size_t sizes_b[2];
    FILE *header = open_memstream(&texts[0], &sizes_b[0]), *source = open_memstream(&texts[1], &sizes_b[1]);
    const bool ok = header && source ? module_c_write(module, "module", header, source, err)
                                     : error_set(err, "no memory for a module");
    if (header) fclose(header);
    if (source) fclose(source);
    return ok;
}

static bool add_driver(const struct module_choice *module, struct amalgam *joined, FILE *out, struct error *err)
{
    static const char *const common[] = {"hal/wire.c", "hal/pixels.c", "hal/greys.c"};
    char family[64], chip[64];
    snprintf(family, sizeof family, "hal/%s.c", module->panel.family->driver);
    snprintf(chip, sizeof chip, "hal/%s.c", module->panel.name);
    for (size_t i = 0; i < sizeof common / sizeof *common; i++)
        if (!amalgam_add(joined, common[i], out, err)) return false;
    return amalgam_add(joined, family, out, err) && amalgam_add(joined, chip, out, err);
}

static bool add_glue(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err)
{
    char *glue = NULL;
    size_t glue_b;
    FILE *memory = open_memstream(&glue, &glue_b);
    if (!memory) return error_set(err, "no memory for a display");
    bool ok = write_glue(plan, memory, err);
    fclose(memory);
    ok = ok && amalgam_add_text(joined, "the scene on the display", glue, out, err);
    free(glue);
    return ok;
}

bool display_c_write_source(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err)
{
    char header_alias[64];
    snprintf(header_alias, sizeof header_alias, "%s.h", plan->module->panel.family->driver);
    const char *const aliases[] = {"panels.h", header_alias, NULL};
    char *texts[2] = {NULL, NULL};
    joined->aliases = aliases;
    fprintf(out, "/* %s_display.h says what this is. */\n#include \"%s_display.h\"\n%s", plan->name->symbol,
            plan->name->symbol, EXPORT_UNUSED);
    if (plan->module->panel.format == PANEL_MONO_PAGES) {
        fputs("\n#define PIXELS_ONLY_PAGES 1\n", out);
        conditions_define(&joined->conditions, "PIXELS_ONLY_PAGES", "1");
    }
    const bool ok = module_texts(plan->module, texts, err) && add_driver(plan->module, joined, out, err) &&
                    amalgam_add(joined, "boards/common/screen.c", out, err) &&
                    amalgam_add_text(joined, "boards/common/module.h", texts[0], out, err) &&
                    amalgam_add_text(joined, "boards/common/module.c", texts[1], out, err) &&
                    add_glue(plan, joined, out, err);
    joined->aliases = NULL;
    free(texts[0]);
    free(texts[1]);
    return ok;
}
