/* SPDX-License-Identifier: MIT
 *
 * A closed Catmull-Rom curve through key points, for the eye and for what it looks at. The walk is
 * paced by effort, way plus turning, so that it slows down in bends. */
#include "demo_walk.h"
#include "demo_vec.h"

enum { FRAMES = 96, FINE = 64 };

static const double effort_per_rad_m = 1.2; /* turning by a radian takes as long as walking this far */

struct key {
    struct vec3 eye, target;
};

static const struct key keys[] = {
    {{2.10, 1.50, 6.40}, {1.95, 1.35, 2.2}},  {{2.00, 1.50, 4.92}, {2.30, 1.25, 0.6}},
    {{2.15, 1.50, 3.60}, {3.40, 1.20, 1.0}},  {{2.75, 1.50, 2.85}, {4.70, 1.15, 3.6}},
    {{3.90, 1.50, 2.60}, {5.90, 1.30, 2.75}}, {{5.52, 1.50, 2.60}, {8.20, 1.25, 1.9}},
    {{7.00, 1.50, 2.60}, {9.40, 1.25, 2.0}},  {{8.58, 1.50, 2.60}, {11.5, 1.15, 2.1}},
    {{10.2, 1.50, 2.85}, {13.0, 1.10, 2.9}},  {{11.6, 1.50, 3.45}, {12.9, 1.25, 5.6}},
    {{12.35, 1.50, 4.97}, {13.6, 1.35, 7.9}}, {{12.75, 1.50, 6.35}, {13.3, 1.45, 9.6}},
    {{12.40, 1.50, 7.25}, {10.9, 1.35, 8.3}}, {{11.08, 1.50, 7.50}, {8.8, 1.15, 6.9}},
    {{9.30, 1.50, 7.50}, {6.6, 1.25, 7.1}},   {{7.58, 1.50, 7.50}, {5.2, 1.30, 6.5}},
    {{6.00, 1.50, 7.50}, {3.5, 1.30, 7.4}},   {{4.52, 1.50, 7.50}, {1.6, 1.15, 7.6}},
    {{3.05, 1.50, 7.45}, {1.5, 1.25, 5.5}},
};
enum { KEYS = sizeof keys / sizeof *keys };

static struct vec3 catmull_rom(struct vec3 a, struct vec3 b, struct vec3 c, struct vec3 d, double t)
{
    double wa = ((2 - t) * t - 1) * t / 2, wb = ((3 * t - 5) * t * t + 2) / 2;
    double wc = ((4 - 3 * t) * t + 1) * t / 2, wd = (t - 1) * t * t / 2;
    return vec_add(vec_add(vec_scale(a, wa), vec_scale(b, wb)), vec_add(vec_scale(c, wc), vec_scale(d, wd)));
}

static struct key key_at(double position)
{
    int i = (int)position;
    double t = position - i;
    const struct key *a = &keys[(i + KEYS - 1) % KEYS], *b = &keys[i % KEYS];
    const struct key *c = &keys[(i + 1) % KEYS], *d = &keys[(i + 2) % KEYS];
    return (struct key){catmull_rom(a->eye, b->eye, c->eye, d->eye, t),
                        catmull_rom(a->target, b->target, c->target, d->target, t)};
}

static double effort(struct key from, struct key to)
{
    struct vec3 a = vec_unit(vec_sub(from.target, from.eye)), b = vec_unit(vec_sub(to.target, to.eye));
    return vec_length(vec_sub(to.eye, from.eye)) + effort_per_rad_m * vec_length(vec_cross(a, b));
}

bool walk_write(FILE *file)
{
    double spent[KEYS * FINE + 1] = {0};
    for (int i = 0; i < KEYS * FINE; i++)
        spent[i + 1] = spent[i] + effort(key_at((double)i / FINE), key_at((double)(i + 1) / FINE));
    int at = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
        double due = spent[KEYS * FINE] * frame / FRAMES;
        while (spent[at + 1] <= due)
            at++;
        struct key key = key_at((at + (due - spent[at]) / (spent[at + 1] - spent[at])) / FINE);
        if (fprintf(file, "%.6f %.6f %.6f %.6f %.6f %.6f\n", key.eye.x, key.eye.y, key.eye.z, key.target.x,
                    key.target.y, key.target.z) < 0)
            return false;
    }
    return true;
}
