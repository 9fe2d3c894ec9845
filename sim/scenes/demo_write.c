/* SPDX-License-Identifier: MIT
 *
 * Writes OBJ and MTL: one material per colour, named by it; corners shared, to a micrometre. */
#include "demo_write.h"

#include <stdlib.h>

/* A corner in micrometres, and where it is used. */
struct corner {
    long at_um[3];
    size_t polygon;
    int index;
    size_t number; /* 1-based, in the file */
};

static int compare_colour(const void *a, const void *b)
{
    const struct polygon *p = a, *q = b;
    if (p->colour != q->colour) return p->colour < q->colour ? -1 : 1;
    return p->order < q->order ? -1 : 1;
}

void write_prepare(struct soup *soup)
{
    for (size_t i = 0; i < soup->count; i++)
        soup->polygons[i].order = i;
    qsort(soup->polygons, soup->count, sizeof *soup->polygons, compare_colour);
}

static int compare_place(const void *a, const void *b)
{
    const struct corner *p = a, *q = b;
    for (int axis = 0; axis < 3; axis++)
        if (p->at_um[axis] != q->at_um[axis]) return p->at_um[axis] < q->at_um[axis] ? -1 : 1;
    return 0;
}

static struct corner *list_corners(const struct soup *soup, size_t *count)
{
    struct corner *list = demo_realloc(NULL, soup->count * POLYGON_CORNERS * sizeof *list);
    *count = 0;
    for (size_t i = 0; i < soup->count; i++)
        for (int j = 0; j < soup->polygons[i].count; j++) {
            struct vec3 at_um = vec_scale(soup->polygons[i].corner[j], 1e6);
            list[(*count)++] = (struct corner){{lround(at_um.x), lround(at_um.y), lround(at_um.z)}, i, j, 0};
        }
    qsort(list, *count, sizeof *list, compare_place);
    return list;
}

/* Metres as float32 numbers, all their digits: every program reads the same house, whatever its numbers are. */
static double float32_m(long um)
{
    return (double)(float)((double)um / 1e6);
}

bool write_obj(FILE *file, const struct soup *soup)
{
    size_t count, number = 0;
    struct corner *list = list_corners(soup, &count);
    size_t(*used)[POLYGON_CORNERS] = demo_realloc(NULL, soup->count * sizeof *used);
    fputs("# The house of a painter of miniatures; written by generate_demo, light baked into the colours\n"
          "mtllib demo.mtl\n",
          file);
    for (size_t i = 0; i < count; i++) {
        if (i == 0 || compare_place(&list[i - 1], &list[i]) != 0) {
            number++;
            fprintf(file, "v %.17g %.17g %.17g\n", float32_m(list[i].at_um[0]), float32_m(list[i].at_um[1]),
                    float32_m(list[i].at_um[2]));
        }
        used[list[i].polygon][list[i].index] = number;
    }
    for (size_t i = 0; i < soup->count; i++) {
        const struct polygon *polygon = &soup->polygons[i];
        if (i == 0 || polygon->colour != polygon[-1].colour) fprintf(file, "usemtl c%06x\n", (unsigned)polygon->colour);
        fputc('f', file);
        for (int j = 0; j < polygon->count; j++)
            fprintf(file, " %zu", used[i][j]);
        fputc('\n', file);
    }
    free(used);
    free(list);
    return !ferror(file);
}

bool write_mtl(FILE *file, const struct soup *soup)
{
    fputs("# Colours of demo.obj; Kd is the colour as shown, in sRGB\n", file);
    for (size_t i = 0; i < soup->count; i++) {
        unsigned colour = (unsigned)soup->polygons[i].colour;
        if (i && colour == soup->polygons[i - 1].colour) continue;
        fprintf(file, "newmtl c%06x\nillum 0\nKd %.6f %.6f %.6f\n", colour, (colour >> 16) / 255.0,
                (colour >> 8 & 255) / 255.0, (colour & 255) / 255.0);
    }
    return !ferror(file);
}
