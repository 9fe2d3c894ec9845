/* SPDX-License-Identifier: MIT
 *
 * A face's number is its colour, 8 bits each in red, green and blue: no light, no dithering, no
 * smoothing, so that it comes back as it went in. OpenGL's pixel centres lie at halves, as
 * reference.h has them, but its rows run upwards.
 *
 * Corners are rounded to 1/256 of a pixel (GL_SUBPIXEL_BITS), which is coarser than what profile exact
 * promises. So the picture is drawn DENSITY times as wide and high, and every pixel read in the middle
 * of its DENSITY x DENSITY ones, which for an odd number is the pixel's own centre. That divides the
 * rounding by DENSITY; the depth buffer's rounding matters less, too, as it draws finer lines. */
#include "osmesa.h"

#include <GL/osmesa.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DENSITY = 5 };

/* Under the leak sanitizer, which asks for this by name: the library keeps a few hundred bytes for good. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libOSMesa.so";
}

bool osmesa_init(struct osmesa *osmesa, unsigned w_px, unsigned h_px, struct error *err)
{
    *osmesa = (struct osmesa){.w_px = w_px, .h_px = h_px, .density = DENSITY};
    const int drawn_w_px = (int)w_px * DENSITY, drawn_h_px = (int)h_px * DENSITY;
    osmesa->rgba = calloc((size_t)drawn_w_px * (size_t)drawn_h_px, 4);
    osmesa->context = OSMesaCreateContextExt(OSMESA_RGBA, 32, 0, 0, NULL);
    if (!osmesa->rgba || !osmesa->context ||
        !OSMesaMakeCurrent(osmesa->context, osmesa->rgba, GL_UNSIGNED_BYTE, drawn_w_px, drawn_h_px)) {
        osmesa_free(osmesa);
        return error_set(err, "OSMesa: no context");
    }
    osmesa->renderer = (const char *)glGetString(GL_RENDERER);
    glGetIntegerv(GL_SUBPIXEL_BITS, &osmesa->sub_pixel_bits);
    glGetIntegerv(GL_DEPTH_BITS, &osmesa->depth_bits);
    glViewport(0, 0, drawn_w_px, drawn_h_px);
    glDisable(GL_DITHER);
    glEnable(GL_DEPTH_TEST);
    return true;
}

static const double *corner(const struct model *model, const struct model_face *face, uint32_t k)
{
    return model->points[model->corners[face->first + k % face->count]];
}

/* Newell's normal against a ray from the eye. */
static bool is_seen_from(const struct model *model, const struct model_face *face, const double eye_m[3])
{
    const double *origin = corner(model, face, 0);
    double sum = 0;

    for (uint32_t k = 0; k < face->count; k++) {
        const double *p = corner(model, face, k), *q = corner(model, face, k + 1);
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, l = (i + 2) % 3;
            sum += (eye_m[i] - origin[i]) *
                   ((p[j] - origin[j]) * (q[l] - origin[l]) - (p[l] - origin[l]) * (q[j] - origin[j]));
        }
    }
    return face->two_sided ? sum != 0 : sum > 0;
}

/* Just beyond the farthest corner: what is left over of the depth buffer's range is lost. */
static double far_m(const struct model *model, const double eye_m[3], double near_m)
{
    double far2 = near_m * near_m;

    for (size_t i = 0; i < model->corner_count; i++) {
        const double *p = model->points[model->corners[i]];
        double distance2 = 0;
        for (int k = 0; k < 3; k++)
            distance2 += (p[k] - eye_m[k]) * (p[k] - eye_m[k]);
        far2 = fmax(far2, distance2);
    }
    return 1.01 * sqrt(far2);
}

static void set_camera(const struct viewpoint *viewpoint, const struct lens *lens, double far)
{
    const double right = lens->near_m * lens->tan_x, top = lens->near_m * lens->tan_y;
    const double *eye = viewpoint->eye_m;
    struct view_axes axes;
    double columns[16] = {[15] = 1};

    viewpoint_axes(viewpoint, &axes);
    for (int i = 0; i < 3; i++) {
        columns[4 * i] = axes.right[i];
        columns[4 * i + 1] = axes.up[i];
        columns[4 * i + 2] = -axes.forward[i];
    }
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-right, right, -top, top, lens->near_m, far);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(columns);
    glTranslated(-eye[0], -eye[1], -eye[2]);
}

static void draw_face(const struct model *model, size_t face)
{
    const uint32_t number = (uint32_t)face + 1;

    glColor3ub((GLubyte)number, (GLubyte)(number >> 8), (GLubyte)(number >> 16));
    glBegin(GL_POLYGON);
    for (uint32_t k = 0; k < model->faces[face].count; k++)
        glVertex3dv(corner(model, &model->faces[face], k));
    glEnd();
}

static void read_faces(const struct osmesa *osmesa, uint32_t *faces)
{
    const size_t line_px = (size_t)osmesa->w_px * DENSITY;

    for (size_t y = osmesa->h_px; y-- > 0;) {
        for (size_t x = 0; x < osmesa->w_px; x++) {
            const uint8_t *at = &osmesa->rgba[4 * ((y * DENSITY + DENSITY / 2) * line_px + x * DENSITY + DENSITY / 2)];
            *faces++ = (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16;
        }
    }
}

void osmesa_draw(struct osmesa *osmesa, const struct model *model, const struct viewpoint *viewpoint,
                 const struct lens *lens, uint32_t *faces)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    set_camera(viewpoint, lens, far_m(model, viewpoint->eye_m, lens->near_m));
    for (size_t f = 0; f < model->face_count; f++)
        if (is_seen_from(model, &model->faces[f], viewpoint->eye_m)) draw_face(model, f);
    glFinish();
    read_faces(osmesa, faces);
}

void osmesa_free(struct osmesa *osmesa)
{
    if (osmesa->context) OSMesaDestroyContext(osmesa->context);
    free(osmesa->rgba);
    memset(osmesa, 0, sizeof *osmesa);
}
