/* SPDX-License-Identifier: MIT
 *
 * Corners are rounded here anew, and planes are taken from the scene's own arrays: nothing is believed of what the
 * stages before have counted. */
#include "compiler/faithful.h"

#include "base/grow.h"
#include "base/notice.h"
#include "base/vec3.h"
#include "cameras/camera_path.h"
#include "compiler/tree_choice.h"
#include "core/core.h"
#include "model/extent.h"
#include "model/grid.h"
#include "model/original.h"
#include "scene/method.h"
#include "scene/records.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAMED = 3, ROUNDS = 8 };
static const double COVERED_UNITS = 2.0; /* a surface that is as near takes a sliver's place */
static const double JOINED = 2.0;        /* how much larger faces may be that are left out with one */

/* The planes of a face's records, each once: a bent face has several. */
struct face_planes {
    const struct lim_plane_ref **refs;
    size_t count, capacity;
};

/* What is asked of every face. */
struct judging {
    const struct original *original;
    const struct mesh *mesh;
    const struct compiled *scene; /* or NULL */
    bool has_fractions;
    struct face_planes *planes; /* of each face number of the mesh, by which its records are seen; count 0: none */
    bool *is_drawn;             /* of each: whether it has records. A mesh has records without planes */
    double seen_m;              /* what is smaller is not looked at */
    double cut_m; /* what is smaller is cut away where a camera comes as near; 0: it is not, or was asked for */
    uint8_t *faults;
};

static void to_units(const struct grid *grid, const double at_m[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = (at_m[i] - grid->origin_m[i]) * grid->units_per_m;
}

static double rounded(double units, bool has_fractions)
{
    return has_fractions ? floor(units * 256.0 + 0.5) / 256.0 : floor(units + 0.5);
}

/* How far the farthest corner is drawn from where the file has it, units: by the weld and by rounding. */
static double corners_moved(const struct judging *judging, const struct original_face *face, bool has_fractions)
{
    const struct grid *grid = &judging->mesh->grid;
    double most2 = 0;
    for (uint32_t k = face->first; k < face->first + face->count; k++) {
        double from[3], to[3];
        to_units(grid, judging->original->corners_m[k], from);
        to_units(grid, judging->mesh->points[judging->original->points[k]], to);
        for (int i = 0; i < 3; i++)
            to[i] = rounded(to[i], has_fractions);
        most2 = fmax(most2, vec3_distance2(from, to));
    }
    return sqrt(most2);
}

static double off_plane(const struct judging *judging, const struct lim_plane_ref *ref, const double at_m[3])
{
    int64_t n[3], d;
    double at[3];
    plane_exact(&judging->scene->scene, ref, n, &d);
    const double normal[3] = {(double)n[0], (double)n[1], (double)n[2]};
    to_units(&judging->mesh->grid, at_m, at);
    return fabs(vec3_dot(normal, at) - (double)d) / sqrt(vec3_dot(normal, normal));
}

static double off_planes(const struct judging *judging, const struct face_planes *planes, const double at_m[3])
{
    double least = INFINITY;
    for (size_t i = 0; i < planes->count; i++)
        least = fmin(least, off_plane(judging, planes->refs[i], at_m));
    return least;
}

static int by_face(const void *face, const void *piece)
{
    const uint32_t a = *(const uint32_t *)face, b = ((const struct mesh_piece *)piece)->face;
    return (a > b) - (a < b);
}

/* Pieces of a face that are not where its first one is; *end is behind the last. NULL: there are none. */
static const struct mesh_piece *pieces_of(const struct mesh *mesh, uint32_t face, const struct mesh_piece **end)
{
    const struct mesh_piece *all = mesh->pieces, *first;
    if (!mesh->piece_count || !(first = bsearch(&face, all, mesh->piece_count, sizeof *all, by_face))) return NULL;
    for (*end = first; *end < all + mesh->piece_count && (*end)->face == face; ++*end)
        ;
    while (first > all && first[-1].face == face)
        first--;
    return first;
}

/* How far the farthest corner is off the plane of its part of the face, by which the renderer decides whether that is
 * seen, units. A bent face is several triangles, each with a plane of its own. */
static double plane_off(const struct judging *judging, size_t index)
{
    const struct original_face *face = &judging->original->faces[index];
    const uint32_t number = (uint32_t)index + 1;
    const struct face_planes *first = &judging->planes[judging->mesh->merged_into[number]];
    const struct mesh_piece *end = NULL, *pieces = pieces_of(judging->mesh, number, &end);
    double most = 0;
    if (!first->count) return 0; /* the faces of a mesh, and of a mesh leaf, are seen by the corners that are drawn */
    for (uint32_t k = face->first; k < face->first + face->count; k++) {
        const double *at_m = judging->original->corners_m[k];
        double off = off_planes(judging, first, at_m);
        for (const struct mesh_piece *piece = pieces; piece && piece < end; piece++)
            off = fmin(off, off_planes(judging, &judging->planes[piece->into], at_m));
        most = fmax(most, off);
    }
    return most;
}

static bool is_drawn(const struct judging *judging, size_t face)
{
    return judging->is_drawn[judging->mesh->merged_into[face + 1]];
}

/* Planes ------------------------------------------------------------------------------------- */

static void plane_add(struct face_planes *planes, const struct lim_plane_ref *ref)
{
    for (size_t i = 0; ref && i < planes->count; i++)
        if (planes->refs[i]->plane == ref->plane && planes->refs[i]->offset == ref->offset) return;
    if (!ref) return; /* a mesh leaf's */
    planes->refs = grow(planes->refs, planes->count, &planes->capacity, sizeof(const struct lim_plane_ref *));
    planes->refs[planes->count++] = ref;
}

static void note_run(struct judging *judging, const uint32_t *numbers, lim_index run, const struct lim_plane_ref *split)
{
    const struct lim_scene *scene = &judging->scene->scene;
    if (run == LIM_NO_INDEX) return;
    for (size_t word = run;; word += record_at(scene, word).words) {
        const uint32_t face = judging->scene->faces[numbers[word]];
        const struct lim_plane_ref *own =
            record_at(scene, word).flags & LIM_POLYGON_PLANE ? lim_record_plane(&scene->polygons[word]) : NULL;
        plane_add(&judging->planes[face], split ? split : own);
        if (record_at(scene, word).flags & LIM_POLYGON_LAST) return;
    }
}

static void note_planes(struct judging *judging)
{
    const struct lim_scene *scene = &judging->scene->scene;
    uint32_t *numbers = grow_zeroed(scene->polygon_words, sizeof *numbers); /* of the record that begins there */
    for (size_t word = 0, number = 0; word < scene->polygon_words; word += record_at(scene, word).words) {
        judging->is_drawn[judging->scene->faces[number]] = true;
        numbers[word] = (uint32_t)number++;
    }
    for (size_t i = 0; i < scene->node_count; i++) {
        const struct lim_node *node = &scene->nodes[i];
        const bool is_leaf = node->split.plane == LIM_NO_INDEX;
        note_run(judging, numbers, node->front_run, is_leaf ? NULL : &node->split);
        if (!is_leaf) note_run(judging, numbers, node->back_run, &node->split);
    }
    free(numbers);
}

/* Slivers ------------------------------------------------------------------------------------ */

static bool near_triangle(const double a[3], const double b[3], const double c[3], const double p[3], double near_m)
{
    const double near2 = near_m * near_m;
    if (vec3_segment_distance2(a, b, p) < near2 || vec3_segment_distance2(b, c, p) < near2 ||
        vec3_segment_distance2(c, a, p) < near2)
        return true;
    double ab[3], ac[3], ap[3];
    vec3_sub(ab, b, a);
    vec3_sub(ac, c, a);
    vec3_sub(ap, p, a);
    const double bb = vec3_dot(ab, ab), bc = vec3_dot(ab, ac), cc = vec3_dot(ac, ac);
    const double pb = vec3_dot(ap, ab), pc = vec3_dot(ap, ac), all = bb * cc - bc * bc;
    if (!(all > 0)) return false;
    const double s = (cc * pb - bc * pc) / all, t = (bb * pc - bc * pb) / all;
    if (s < 0 || t < 0 || s + t > 1) return false;
    return vec3_dot(ap, ap) - (s * pb + t * pc) < near2;
}

static bool is_near(const struct original *original, const struct original_face *face, const double p[3], double near_m)
{
    double(*corners)[3] = &original->corners_m[face->first];
    const double reach_m = face->radius_m + near_m;
    if (vec3_distance2(face->centre_m, p) > reach_m * reach_m) return false;
    for (uint32_t k = 2; k < face->count; k++)
        if (near_triangle(corners[0], corners[k - 1], corners[k], p, near_m)) return true;
    return false;
}

/* Whether faces that the sliver is joined to, and that are drawn, take its place: its corners' and its middle's. */
static bool is_covered(const struct judging *judging, const struct original_face *sliver)
{
    const struct original *original = judging->original;
    const double near_m = COVERED_UNITS / judging->mesh->grid.units_per_m;
    for (uint32_t k = 0; k <= sliver->count; k++) {
        const double *p = k < sliver->count ? original->corners_m[sliver->first + k] : sliver->centre_m;
        bool any = false;
        for (size_t i = 0; i < original->face_count && !any; i++) {
            const struct original_face *face = &original->faces[i];
            any = face->thing == sliver->thing && face->count && is_drawn(judging, i) &&
                  is_near(original, face, p, near_m);
        }
        if (!any) return false;
    }
    return true;
}

/* Judging ------------------------------------------------------------------------------------ */

static enum faithful_fault judge_place(const struct judging *judging, size_t index)
{
    const struct original_face *face = &judging->original->faces[index];
    const double size_units = face->size_m * judging->mesh->grid.units_per_m;
    const bool moved = corners_moved(judging, face, judging->has_fractions) > FAITHFUL_SHARE * size_units;
    if (!judging->scene) return moved ? FAITHFUL_MOVED : FAITHFUL_KEPT;
    if (is_drawn(judging, index))
        return moved || plane_off(judging, index) > FAITHFUL_PLANE_SHARE * size_units ? FAITHFUL_MOVED : FAITHFUL_KEPT;
    if (moved) return FAITHFUL_VANISHED;
    return face->width_m < judging->seen_m || is_covered(judging, face) ? FAITHFUL_KEPT : FAITHFUL_VANISHED;
}

static enum faithful_fault judge_face(const struct judging *judging, size_t index)
{
    const struct original_face *face = &judging->original->faces[index];
    if (!face->count || face->size_m < judging->seen_m) return FAITHFUL_KEPT;
    const enum faithful_fault fault = judge_place(judging, index);
    return fault == FAITHFUL_KEPT && face->size_m < judging->cut_m ? FAITHFUL_CUT : fault;
}

static bool is_exact(const struct compile_options *options)
{
    return options->core && options->core->profile == LIM_PROFILE_EXACT;
}

static struct judging judging_of(const struct mesh *mesh, const struct compile_options *options,
                                 const struct compiled *scene)
{
    const bool is_chosen = options->near_m > 0.0;
    const double forced_m = fmax(options->forced_near_m, lens_forced_near_m(&mesh->grid));
    struct judging judging = {.original = mesh->original,
                              .mesh = mesh,
                              .scene = scene,
                              .has_fractions = is_exact(options) || mesh->grid.has_fractions,
                              .seen_m = FAITHFUL_PIXEL * (is_chosen ? options->near_m : lens_usual_near_m(&mesh->grid)),
                              .cut_m = is_chosen || options->drop_small ? 0.0 : forced_m};
    if (!scene) return judging;
    judging.planes = grow_zeroed(mesh->counts.faces + 1, sizeof *judging.planes);
    judging.is_drawn = grow_zeroed(mesh->counts.faces + 1, sizeof *judging.is_drawn);
    note_planes(&judging);
    return judging;
}

static void judging_free(struct judging *judging)
{
    for (size_t i = 0; judging->planes && i <= judging->mesh->counts.faces; i++)
        free(judging->planes[i].refs);
    free(judging->planes);
    free(judging->is_drawn);
}

/* For each face of the original what became of it; the caller's to free. `scene`: NULL, the grid alone is judged, for
 * what options->core rounds to. */
static uint8_t *judge(const struct mesh *mesh, const struct compile_options *options, const struct compiled *scene)
{
    struct judging judging = judging_of(mesh, options, scene);
    uint8_t *faults = grow_zeroed(mesh->original->face_count, sizeof *faults);
    for (size_t i = 0; i < mesh->original->face_count; i++)
        faults[i] = (uint8_t)judge_face(&judging, i);
    judging_free(&judging);
    return faults;
}

bool faithful_wants_finer(const struct mesh *mesh, const struct compile_options *options)
{
    if (!mesh->original) return false;
    uint8_t *faults = judge(mesh, options, NULL);
    bool any = false;
    for (size_t i = 0; i < mesh->original->face_count && !any; i++)
        any = faults[i] != FAITHFUL_KEPT;
    free(faults);
    return any;
}

/* Refusing ----------------------------------------------------------------------------------- */

/* Whether fractions of units would do: not for what the near plane cuts away, in any precision. A plane that is not
 * known may be off by the tolerance. */
static bool exact_helps(const struct mesh *mesh, const struct compile_options *options, const struct compiled *scene,
                        const uint8_t *faults)
{
    struct judging judging = judging_of(mesh, options, scene);
    bool helps = !judging.has_fractions;
    for (size_t i = 0; i < mesh->original->face_count && helps; i++) {
        const struct original_face *face = &mesh->original->faces[i];
        const double size_units = face->size_m * mesh->grid.units_per_m;
        helps = !face->count || face->size_m < judging.seen_m || face->size_m >= judging.cut_m;
        if (!faults[i] || !helps) continue;
        const bool is_known = scene && is_drawn(&judging, i);
        const double off = is_known ? plane_off(&judging, i) : options->tolerance_units;
        helps = corners_moved(&judging, face, true) <= FAITHFUL_SHARE * size_units &&
                off <= FAITHFUL_PLANE_SHARE * size_units;
    }
    judging_free(&judging);
    return helps;
}

/* The smallest come first; what the near plane cuts away only if nothing is worse. Returns how many there are, and sets
 * *worst to what became of the worst of them. */
static size_t name_faults(const struct original *original, const uint8_t *faults, char *names, size_t names_b,
                          uint8_t *worst)
{
    size_t count = 0, length = 0;
    *worst = FAITHFUL_KEPT;
    for (size_t i = 0; i < original->face_count; i++)
        if (faults[i] > *worst) *worst = faults[i];
    for (size_t i = 0; i < original->seen_count; i++) {
        const struct original_face *face = &original->faces[original->by_size[i]];
        const uint8_t fault = faults[original->by_size[i]];
        if (!fault || (fault == FAITHFUL_CUT && *worst != FAITHFUL_CUT)) continue;
        if (count++ < NAMED)
            length += (size_t)snprintf(names + length, names_b - length, "%s%lu (%.3g m)", count > 1 ? ", " : "",
                                       (unsigned long)face->number, face->size_m);
    }
    return count;
}

/* Whether coordinates of 32 bits would do. Of the mesh only what it was made from counts, which nobody has welded. */
static bool long_helps(const struct mesh *mesh, const struct compile_options *options)
{
    struct original original = *mesh->original;
    struct mesh own = *mesh;
    const struct grid_views views = {.near_m = options->near_m};
    if (mesh->grid.is_long || options->whole_leaf) return false;
    original.points = grow_zeroed(original.corner_count, sizeof *original.points);
    for (uint32_t i = 0; i < original.corner_count; i++)
        original.points[i] = i;
    own.original = &original;
    own.points = original.corners_m;
    grid_scale_long(extent_longest_side(original.corners_m, original.points, (uint32_t)original.corner_count),
                    original.faces[original.by_size[0]].size_m, &views, &own.grid);
    const bool helps = !faithful_wants_finer(&own, options);
    free(original.points);
    return helps;
}

/* What a refusal advises: what draws the model as it is, and only where nothing does, to change it. */
static const char *advice(const struct mesh *mesh, const struct compile_options *options, bool exact_does)
{
    static const char *const texts[2][2] = {
        {"split the model into several scenes, enlarge what is small", "take --precision exact"},
        {"take --coordinates 32", "take --coordinates 32, take --precision exact"}};
    const bool long_does = mesh->original->seen_count && long_helps(mesh, options);
    if (long_does && !compile_options_may_be_long(options))
        return exact_does ? texts[0][1]
                          : "take a method that walks a tree, without --mesh-leaves all, for coordinates of 32 bits";
    return texts[long_does][exact_does];
}

static bool refuse(const struct mesh *mesh, const struct compile_options *options, const struct compiled *scene,
                   const uint8_t *faults, struct error *err)
{
    const struct original *original = mesh->original;
    const double unit_m = 1.0 / mesh->grid.units_per_m;
    char names[96] = "";
    uint8_t worst;
    const size_t count = name_faults(original, faults, names, sizeof names, &worst);
    const char *more = count > NAMED ? " ..." : "";
    if (worst == FAITHFUL_CUT)
        return error_set(err,
                         "face %s%s: %zu of %zu faces are smaller than the distance within which nothing is drawn on a "
                         "grid with units of %.3g m; %s, or give --near %.3g",
                         names, more, count, original->seen_count, unit_m, advice(mesh, options, false),
                         fmax(options->forced_near_m, lens_forced_near_m(&mesh->grid)) * LENS_PRINTED_UP);
    return error_set(err,
                     "face %s%s: %zu of %zu faces would vanish or move too far on a grid with units of %.3g m; %s, or "
                     "leave it out by --drop-small",
                     names, more, count, original->seen_count, unit_m,
                     advice(mesh, options, exact_helps(mesh, options, scene, faults)));
}

/* Leaving out -------------------------------------------------------------------------------- */

/* All of a small thing goes: one that lacks a side, or has one that moved, is not what the model shows either. */
static void add_joined(const struct original *original, uint8_t *faults)
{
    double *largest = grow_zeroed(original->face_count, sizeof *largest);
    for (size_t i = 0; i < original->face_count; i++) {
        double *of = &largest[original->faces[i].thing];
        if (faults[i]) *of = fmax(*of, original->faces[i].size_m);
    }
    for (size_t i = 0; i < original->face_count; i++) {
        const struct original_face *face = &original->faces[i];
        if (face->count && face->size_m <= JOINED * largest[face->thing]) faults[i] = FAITHFUL_VANISHED;
    }
    free(largest);
}

/* Takes their polygons out of the mesh; of merged ones all go. Returns whether any did. */
static bool leave_out(struct mesh *mesh, const uint8_t *faults, bool *is_out)
{
    const size_t before = mesh->polygon_count;
    for (size_t i = 0; i < mesh->original->face_count; i++)
        if (faults[i]) is_out[mesh->merged_into[i + 1]] = true;
    mesh->polygon_count = 0;
    for (size_t i = 0; i < before; i++)
        if (!is_out[mesh->polygons[i].face]) mesh->polygons[mesh->polygon_count++] = mesh->polygons[i];
    return mesh->polygon_count < before;
}

static size_t count_out(const struct mesh *mesh, const uint8_t *faults, const bool *is_out)
{
    size_t count = 0;
    for (size_t i = 0; i < mesh->original->face_count; i++) {
        const uint32_t group = mesh->merged_into[i + 1];
        count += mesh->original->faces[i].count && (group ? is_out[group] : faults[i] != FAITHFUL_KEPT);
    }
    return count;
}

/* A copy of the mesh with polygons of its own, that fewer and fewer are left of. */
struct leaving {
    struct mesh mesh;
    uint8_t *faults; /* of all rounds */
    bool *is_out;    /* of each face number of the mesh */
    bool is_refused;
};

/* Of a scene, or of rounding alone: false if it cannot be helped. */
static bool settle(struct leaving *leaving, const struct compile_options *options, const struct compiled *scene,
                   bool *changed, struct error *err)
{
    struct mesh *mesh = &leaving->mesh;
    uint8_t *faults = judge(mesh, options, scene);
    bool any = false, ok = true;
    for (size_t i = 0; i < mesh->original->face_count; i++) {
        if (leaving->faults[i]) faults[i] = FAITHFUL_KEPT;                  /* it is out already */
        if (!scene && faults[i] == FAITHFUL_CUT) faults[i] = FAITHFUL_KEPT; /* perhaps it vanishes, which is worse */
        any |= faults[i] != FAITHFUL_KEPT;
    }
    if (any && !options->drop_small) ok = refuse(mesh, options, scene, faults, err);
    leaving->is_refused = !ok;
    if (any && ok) {
        add_joined(mesh->original, faults);
        for (size_t i = 0; i < mesh->original->face_count; i++)
            leaving->faults[i] |= faults[i];
        *changed = leave_out(mesh, leaving->faults, leaving->is_out);
        if (!mesh->polygon_count) ok = error_set(err, "--drop-small: all faces are too small for the grid");
    }
    free(faults);
    return ok;
}

static bool compile_kept(struct leaving *leaving, const struct compile_options *options, struct compiled *out,
                         struct error *err)
{
    bool changed = false;
    if (!settle(leaving, options, NULL, &changed, err)) return false;
    for (int round = 0; round < ROUNDS; round++) {
        changed = false;
        if (!tree_choice_compile(&leaving->mesh, options, out, err)) return false;
        if (!settle(leaving, options, out, &changed, err)) break;
        if (!changed) {
            out->original = original_share(leaving->mesh.original);
            out->report.left_out = count_out(&leaving->mesh, leaving->faults, leaving->is_out);
            return true;
        }
        if (round + 1 < ROUNDS)
            compiled_free(out);
        else
            error_set(err, "--drop-small: what is left is too small for the grid still");
    }
    compiled_free(out);
    return false;
}

bool faithful_compile(const struct mesh *mesh, const struct compile_options *options, struct compiled *out,
                      struct error *err)
{
    *out = (struct compiled){0};
    if (!mesh->original) return tree_choice_compile(mesh, options, out, err);
    struct leaving leaving = {.mesh = *mesh,
                              .faults = grow_zeroed(mesh->original->face_count, 1),
                              .is_out = grow_zeroed(mesh->counts.faces + 1, sizeof *leaving.is_out)};
    leaving.mesh.polygons = grow_zeroed(mesh->polygon_count, sizeof *mesh->polygons);
    memcpy(leaving.mesh.polygons, mesh->polygons, mesh->polygon_count * sizeof *mesh->polygons);
    const bool ok = compile_kept(&leaving, options, out, err);
    out->report.is_refused = !ok && leaving.is_refused;
    free(leaving.mesh.polygons);
    free(leaving.faults);
    free(leaving.is_out);
    return ok;
}

void faithful_note(const struct compiled *scene)
{
    if (scene->report.left_out)
        notice("--drop-small left out %zu of %zu faces, too small for the grid", scene->report.left_out,
               scene->report.mesh.faces);
    if (scene->report.covered)
        notice(
            "%zu faces are covered, in part or whole, by later faces of the file in the same plane: the later one is "
            "drawn over the earlier; move them apart for another order",
            scene->report.covered);
    if (scene->report.unordered)
        notice(
            "%zu faces lie in a plane with others, or nearly: --method %s does not order them; --method nearest draws "
            "them as the file has them",
            scene->report.unordered, method_name(scene->report.draws));
}
