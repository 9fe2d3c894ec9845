/* SPDX-License-Identifier: MIT
 *
 * The frame is drawn twice by the method, in its colours and as face numbers, and once by the reference. */
#include "measure/difference.h"

#include "accuracy/moving_reference.h"
#include "pictures/image.h"
#include "render/ids.h"
#include "render/simulator.h"
#include "scene/moving.h"

#include <gdfonts.h>
#include <string.h>

enum { SHEET_COLUMNS = 4, CAPTION_PX = 15, BORDER_PX = 2, CAPTION_LEFT_PX = 3 };
enum { BORDER_COLOUR = 0x202428, CAPTION_COLOUR = 0xE0E0E0, WRONG_COLOUR = 0xC08000, FAULT_COLOUR = 0xFF2020 };

/* What one picture takes. */
struct drawing {
    struct simulator simulator;
    struct ids ids;
};

/* Where they are in that frame. */
static bool place_movers(struct drawing *drawing, struct measure_source *source, const struct compiled *scene,
                         const struct measure_views *views, size_t frame, struct error *err)
{
    if (!scene->moving) return true;
    const double time_s = camera_path_time_s(views->path, frame, moving_length_s(scene->moving));
    moving_pose(scene->moving, time_s);
    moving_pose_reference(source->still.moving, &source->reference, time_s);
    return simulator_add_movers(&drawing->simulator, scene, err) && ids_set_movers(&drawing->ids, scene->moving, err);
}

static bool draw_frame(struct drawing *drawing, struct measure_source *source,
                       const struct measure_candidate *candidate, const struct measure_views *views, size_t frame,
                       struct error *err)
{
    const struct compiled *scene = candidate->scene;
    const struct simulator_setup setup = {views->w_px, views->h_px, scene->report.draws, SIMULATOR_MEMORY,
                                          candidate->core};
    struct lim_camera camera;
    if (!simulator_init(&drawing->simulator, &scene->scene, &setup, err) ||
        !ids_init(&drawing->ids, scene, &setup, err) || !place_movers(drawing, source, scene, views, frame, err) ||
        !camera_path_to_camera(views->path, frame, views->lens, &scene->grid, &camera, err) ||
        !simulator_frame(&drawing->simulator, &camera, err) || !ids_frame(&drawing->ids, &camera, err))
        return false;
    reference_draw(&source->reference, &views->path->frames[frame], views->lens);
    return true;
}

/* Half as bright, without colour, and never black. */
static int dim_grey(uint16_t colour)
{
    const uint32_t rgb = image_rgb888_from_565(colour);
    const uint32_t grey = 32 + ((rgb >> 16) * 3 + (rgb >> 8 & 255) * 6 + (rgb & 255)) / 20;
    return (int)(grey << 16 | grey << 8 | grey);
}

static void paint(const struct drawing *drawing, const struct measure_source *source, double unit_m, gdImagePtr image)
{
    const size_t w_px = source->reference.w_px, count = w_px * source->reference.h_px;
    for (size_t pixel = 0; pixel < count; pixel++) {
        const enum compare_verdict verdict =
            compare_pixel(drawing->ids.faces, &source->reference, source->mesh.merged_into, unit_m, pixel);
        int *to = &image->tpixels[pixel / w_px][pixel % w_px];
        if (verdict == COMPARE_RIGHT)
            *to = dim_grey(drawing->simulator.pixels[pixel]);
        else
            *to = verdict >= COMPARE_OPEN ? FAULT_COLOUR : WRONG_COLOUR;
    }
}

gdImagePtr difference_picture(struct measure_source *source, const struct measure_candidate *candidate,
                              const struct measure_views *views, size_t frame, struct compare_counts *counts,
                              struct error *err)
{
    const double unit_m = 1.0 / candidate->scene->grid.units_per_m;
    struct drawing drawing = {0};
    gdImagePtr image = NULL;
    if (draw_frame(&drawing, source, candidate, views, frame, err)) {
        image = gdImageCreateTrueColor((int)views->w_px, (int)views->h_px);
        if (image)
            paint(&drawing, source, unit_m, image);
        else
            error_set(err, "difference picture: out of memory");
        if (counts) *counts = compare_picture(drawing.ids.faces, &source->reference, source->mesh.merged_into, unit_m);
    }
    simulator_free(&drawing.simulator);
    ids_free(&drawing.ids);
    return image;
}

gdImagePtr frame_picture(const struct measure_candidate *candidate, const struct measure_views *views, size_t frame,
                         struct lim_stats *stats, struct error *err)
{
    const struct compiled *scene = candidate->scene;
    const struct simulator_setup setup = {views->w_px, views->h_px, scene->report.draws, measure_panel(scene),
                                          candidate->core};
    struct simulator simulator;
    struct lim_camera camera;
    gdImagePtr image = NULL;
    if (!simulator_init(&simulator, &scene->scene, &setup, err)) return NULL;
    if (scene->moving)
        moving_pose(scene->moving, camera_path_time_s(views->path, frame, moving_length_s(scene->moving)));
    if (simulator_add_movers(&simulator, scene, err) &&
        simulator_set_antialias(&simulator, scene->report.antialias, err) &&
        camera_path_to_camera(views->path, frame, views->lens, &scene->grid, &camera, err) &&
        simulator_frame(&simulator, &camera, err)) {
        const struct film film = simulator_film(&simulator);
        image = image_from_frame(&film, 0);
        if (!image) error_set(err, "picture of a frame: out of memory");
        if (stats) *stats = *simulator_stats(&simulator);
    }
    simulator_free(&simulator);
    return image;
}

gdImagePtr difference_sheet(const struct difference_cell *cells, size_t count, unsigned w_px, unsigned h_px)
{
    const int columns = count < SHEET_COLUMNS ? (int)count : SHEET_COLUMNS;
    const int rows = ((int)count + columns - 1) / columns;
    const int step_x_px = (int)w_px + BORDER_PX, step_y_px = (int)h_px + CAPTION_PX + BORDER_PX;
    gdImagePtr sheet = gdImageCreateTrueColor(columns * step_x_px + BORDER_PX, rows * step_y_px + BORDER_PX);
    if (!sheet) return NULL;
    gdImageFilledRectangle(sheet, 0, 0, gdImageSX(sheet) - 1, gdImageSY(sheet) - 1, BORDER_COLOUR);
    for (int i = 0; i < (int)count; i++) {
        const int x_px = BORDER_PX + i % columns * step_x_px, y_px = BORDER_PX + i / columns * step_y_px;
        unsigned char caption[sizeof cells->caption];
        memcpy(caption, cells[i].caption, sizeof caption);
        gdImageSetClip(sheet, x_px, y_px, x_px + (int)w_px - 1, y_px + step_y_px - 1);
        gdImageString(sheet, gdFontGetSmall(), x_px + CAPTION_LEFT_PX, y_px, caption, CAPTION_COLOUR);
        if (cells[i].picture) gdImageCopy(sheet, cells[i].picture, x_px, y_px + CAPTION_PX, 0, 0, (int)w_px, (int)h_px);
    }
    gdImageSetClip(sheet, 0, 0, gdImageSX(sheet) - 1, gdImageSY(sheet) - 1);
    return sheet;
}
