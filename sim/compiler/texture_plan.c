/* SPDX-License-Identifier: MIT
 *
 * Textures that are shown as one are a group: that one, `heads` of it, and the members that show it. */
#include "compiler/texture_plan.h"

#include "base/grow.h"
#include "compiler/encode_texture.h"
#include "model/texture_cut.h"

#include <math.h>
#include <stdlib.h>

enum { LEVELS = TEXELS_SEEN_LEVELS, CHANNELS = 3, COARSE_BITS = 2 };
static const double NEAR_ERROR = CHANNELS * TEXTURE_NEAR_RMS * TEXTURE_NEAR_RMS;

/* A pair that may be merged, as far as small pictures of both tell. */
struct pair {
    uint32_t from, to;
};

/* The least loss a byte so far. */
struct choice {
    enum { NOTHING, CUT, FLAT, MERGE, MEANS } kind;
    uint32_t head, to;
    double loss, a_byte;
};

struct planning {
    const struct mesh *mesh;
    const struct texels_seen *seen;
    const struct texture_mean *means; /* NULL: faces do not take theirs */
    size_t colour_b;
    struct texture_step *steps;
    uint32_t **lights; /* of each texture, that its polygons have: sorted */
    size_t *light_counts;
    size_t (*colours)[LEVELS]; /* of each texture, with so many levels less */
    double (*losses)[LEVELS];  /* of each group, cut by so many levels; below 0: not known */
    struct pair *pairs;
    size_t pair_count, pair_capacity;
    size_t total_b;
};

size_t texture_plan_bytes(const struct mesh *mesh)
{
    struct texture_arrays arrays = {0};
    struct texture_encoder encoder;
    texture_encoder_init(&encoder, mesh, &arrays);
    for (size_t i = 0; i < mesh->polygon_count; i++)
        if (mesh->polygons[i].mapping) texture_encode_look(&encoder, &mesh->polygons[i]);
    texture_encoder_finish(&encoder);
    const size_t bytes = arrays.texel_count + arrays.palette_colours * sizeof *arrays.palettes +
                         arrays.texture_count * sizeof *arrays.textures;
    texture_encoder_free(&encoder);
    texture_arrays_free(&arrays);
    return bytes;
}

/* What a group takes --------------------------------------------------------------------------- */

static int compare_lights(const void *a, const void *b)
{
    const uint32_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static size_t keep_different(uint32_t *lights, size_t count)
{
    size_t kept = 0;
    qsort(lights, count, sizeof *lights, compare_lights);
    for (size_t i = 0; i < count; i++)
        if (!kept || lights[kept - 1] != lights[i]) lights[kept++] = lights[i];
    return kept;
}

static void note_light(struct planning *work, uint32_t texture, uint32_t light)
{
    size_t *const count = &work->light_counts[texture], before = *count;
    if (!(before & (before - 1))) /* a power of two, or none: full, twice the room */
        work->lights[texture] = realloc(work->lights[texture], (before ? 2 * before : 1) * sizeof light);
    if (!work->lights[texture]) abort(); /* as grow() does */
    work->lights[texture][(*count)++] = light;
}

static void find_lights(struct planning *work)
{
    const struct mesh *mesh = work->mesh;
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        const struct mesh_polygon *polygon = &mesh->polygons[i];
        if (polygon->mapping)
            note_light(work, mesh->mappings[polygon->mapping].texture, texture_light_of(polygon->colour));
    }
    for (size_t i = 0; i < mesh->texture_count; i++)
        work->light_counts[i] = keep_different(work->lights[i], work->light_counts[i]);
}

static size_t bytes_with(const struct planning *work, uint32_t head, unsigned cut, size_t lights)
{
    return texture_cut_texels(&work->mesh->textures[head], cut) +
           lights * (work->colours[head][cut] * sizeof(uint16_t) + sizeof(struct lim_texture));
}

static size_t bytes_of(const struct planning *work, uint32_t head)
{
    return bytes_with(work, head, work->steps[head].cut, work->light_counts[head]);
}

/* What is lost --------------------------------------------------------------------------------- */

static bool is_used(const struct planning *work, uint32_t texture)
{
    return work->light_counts[texture] > 0;
}

static bool is_head(const struct planning *work, uint32_t texture)
{
    return is_used(work, texture) && work->steps[texture].shows == texture && !work->steps[texture].is_flat &&
           !work->steps[texture].has_means;
}

static double pixels_of(const struct planning *work, uint32_t texture)
{
    double sum = 0;
    for (int level = 0; level < LEVELS; level++)
        sum += work->seen[texture].pixels[level];
    return sum;
}

/* Of a texture that is shown as another one, or itself, without its finest levels. */
static double loss_as(const struct planning *work, uint32_t texture, uint32_t as, unsigned cut)
{
    const struct texture *from = &work->mesh->textures[texture], *to = &work->mesh->textures[as];
    double sum = 0;
    for (unsigned level = 0; level < from->levels; level++)
        if (work->seen[texture].pixels[level] > 0 && (texture != as || level < cut))
            sum += work->seen[texture].pixels[level] * texture_error(from, level, to, level < cut ? cut : level);
    return sum;
}

static double loss_flat(const struct planning *work, uint32_t texture)
{
    double sum = 0;
    for (unsigned level = 0; level < work->mesh->textures[texture].levels; level++)
        if (work->seen[texture].pixels[level] > 0)
            sum += work->seen[texture].pixels[level] * texture_error_flat(&work->mesh->textures[texture], level);
    return sum;
}

static double loss_of_group(struct planning *work, uint32_t head, unsigned cut)
{
    double *const known = &work->losses[head][cut];
    if (*known >= 0) return *known;
    *known = 0;
    for (uint32_t i = 0; i < work->mesh->texture_count; i++)
        if (is_used(work, i) && work->steps[i].shows == head) *known += loss_as(work, i, head, cut);
    return *known;
}

static void forget_losses(struct planning *work, uint32_t head)
{
    for (int cut = 0; cut < LEVELS; cut++)
        work->losses[head][cut] = -1;
}

static bool is_alone(const struct planning *work, uint32_t head)
{
    for (uint32_t i = 0; i < work->mesh->texture_count; i++)
        if (i != head && work->steps[i].shows == head && is_used(work, i)) return false;
    return true;
}

/* Steps ---------------------------------------------------------------------------------------- */

static void offer(struct choice *best, struct choice offered, size_t spared_b)
{
    if (!spared_b) return;
    offered.a_byte = fmax(offered.loss, 0) / (double)spared_b;
    if (best->kind == NOTHING || offered.a_byte < best->a_byte) *best = offered;
}

static bool may_cut(const struct planning *work, uint32_t head)
{
    const struct texture *texture = &work->mesh->textures[head];
    return texture_is_plain(texture) && texture->h_bits - work->steps[head].cut > TEXTURE_LEAST_BITS;
}

static void offer_cut(struct planning *work, uint32_t head, struct choice *best)
{
    const unsigned cut = work->steps[head].cut;
    if (!may_cut(work, head)) return;
    const size_t now_b = bytes_of(work, head), then_b = bytes_with(work, head, cut + 1, work->light_counts[head]);
    const double loss = loss_of_group(work, head, cut + 1) - loss_of_group(work, head, cut);
    offer(best, (struct choice){.kind = CUT, .head = head, .loss = loss}, now_b - then_b);
}

/* Pictures that are one colour nearly everywhere, wherever they are seen from. */
static void offer_flat(struct planning *work, uint32_t head, struct choice *best)
{
    if (!texture_is_plain(&work->mesh->textures[head])) return;
    if (texture_error_flat(&work->mesh->textures[head], 0) > NEAR_ERROR || !is_alone(work, head)) return;
    const double loss = loss_flat(work, head) - loss_of_group(work, head, work->steps[head].cut);
    offer(best, (struct choice){.kind = FLAT, .head = head, .loss = loss}, bytes_of(work, head));
}

static size_t lights_together(const struct planning *work, uint32_t a, uint32_t b)
{
    size_t i = 0, k = 0, count = 0;
    while (i < work->light_counts[a] || k < work->light_counts[b]) {
        const bool has_a = i < work->light_counts[a], has_b = k < work->light_counts[b];
        const uint32_t light_a = has_a ? work->lights[a][i] : 0, light_b = has_b ? work->lights[b][k] : 0;
        const bool takes_a = has_a && (!has_b || light_a <= light_b);
        const bool takes_b = has_b && (!has_a || light_b <= light_a);
        i += takes_a, k += takes_b, count++;
    }
    return count;
}

static void offer_merge(struct planning *work, const struct pair *pair, struct choice *best)
{
    if (!is_head(work, pair->from) || !is_head(work, pair->to) || !is_alone(work, pair->from)) return;
    const unsigned cut = work->steps[pair->to].cut;
    const size_t now_b = bytes_of(work, pair->from) + bytes_of(work, pair->to);
    const size_t then_b = bytes_with(work, pair->to, cut, lights_together(work, pair->from, pair->to));
    const double loss =
        loss_as(work, pair->from, pair->to, cut) - loss_of_group(work, pair->from, work->steps[pair->from].cut);
    if (then_b < now_b)
        offer(best, (struct choice){.kind = MERGE, .head = pair->from, .to = pair->to, .loss = loss}, now_b - then_b);
}

static void merge(struct planning *work, uint32_t from, uint32_t to)
{
    for (size_t i = 0; i < work->light_counts[from]; i++)
        note_light(work, to, work->lights[from][i]);
    work->light_counts[to] = keep_different(work->lights[to], work->light_counts[to]);
    work->steps[from].shows = to;
    forget_losses(work, to);
}

static void take(struct planning *work, const struct choice *choice)
{
    const size_t now_b = bytes_of(work, choice->head) + (choice->kind == MERGE ? bytes_of(work, choice->to) : 0);
    size_t then_b = 0;
    switch (choice->kind) {
    case CUT:
        work->steps[choice->head].cut++;
        then_b = bytes_of(work, choice->head);
        break;
    case MERGE:
        merge(work, choice->head, choice->to);
        then_b = bytes_of(work, choice->to);
        break;
    case FLAT:
        work->steps[choice->head].is_flat = true;
        break;
    case MEANS:
    case NOTHING:
        break;
    }
    work->total_b = work->total_b - now_b + then_b;
}

static bool take_next(struct planning *work)
{
    struct choice best = {.kind = NOTHING};
    for (uint32_t i = 0; i < work->mesh->texture_count; i++) {
        if (!is_head(work, i)) continue;
        offer_cut(work, i, &best);
        offer_flat(work, i, &best);
    }
    for (size_t i = 0; i < work->pair_count; i++)
        offer_merge(work, &work->pairs[i], &best);
    if (best.kind == NOTHING) return false;
    take(work, &best);
    return true;
}

/* Faces take their means: all that show a group, each of its own texture. */
static void offer_means(struct planning *work, uint32_t head, struct choice *best)
{
    size_t then_b = 0;
    double loss = -loss_of_group(work, head, work->steps[head].cut);
    for (uint32_t i = 0; i < work->mesh->texture_count; i++) {
        if (!is_used(work, i) || work->steps[i].shows != head) continue;
        loss += pixels_of(work, i) * work->means[i].error;
        then_b += work->means[i].colours * work->colour_b;
    }
    const size_t now_b = bytes_of(work, head);
    offer(best, (struct choice){.kind = MEANS, .head = head, .loss = loss}, now_b > then_b ? now_b - then_b : 1);
}

/* Where no texture is left, colours take no place among textures. */
static void take_means(struct planning *work, uint32_t head)
{
    bool is_last = true;
    work->total_b -= bytes_of(work, head);
    for (uint32_t i = 0; i < work->mesh->texture_count; i++) {
        if (!is_used(work, i) || work->steps[i].shows != head) continue;
        work->steps[i].has_means = true;
        work->total_b += work->means[i].colours * work->colour_b;
    }
    for (uint32_t i = 0; i < work->mesh->texture_count; i++)
        is_last &= !is_head(work, i);
    if (is_last) work->total_b = 0;
}

static bool take_next_means(struct planning *work)
{
    struct choice best = {.kind = NOTHING};
    for (uint32_t i = 0; work->means && i < work->mesh->texture_count; i++)
        if (is_head(work, i)) offer_means(work, i, &best);
    if (best.kind == NOTHING) return false;
    take_means(work, best.head);
    return true;
}

/* The last steps may have spared more than was wanted: the level that is missed most, of those that there is room for.
 */
static bool give_back(struct planning *work, size_t budget_b)
{
    uint32_t best = UINT32_MAX;
    double most = 0;
    for (uint32_t i = 0; i < work->mesh->texture_count; i++) {
        const unsigned cut = work->steps[i].cut;
        if (!is_head(work, i) || !cut) continue;
        const size_t more_b = bytes_with(work, i, cut - 1, work->light_counts[i]) - bytes_of(work, i);
        const double gain = loss_of_group(work, i, cut) - loss_of_group(work, i, cut - 1);
        if (work->total_b + more_b <= budget_b && gain > most) best = i, most = gain;
    }
    if (best == UINT32_MAX) return false;
    work->total_b -= bytes_of(work, best);
    work->steps[best].cut--;
    work->total_b += bytes_of(work, best);
    return true;
}

/* Beginning and end ---------------------------------------------------------------------------- */

/* A level of 4 texels' height is as near as the whole picture, or nearer. */
static bool is_near(const struct texture *a, const struct texture *b)
{
    if (!texture_is_alike(a, b)) return false;
    const unsigned coarse = a->h_bits > COARSE_BITS ? (unsigned)a->h_bits - COARSE_BITS : 0u;
    return texture_error(a, coarse, b, coarse) <= NEAR_ERROR && texture_error(a, 0, b, 0) <= NEAR_ERROR;
}

static void find_pairs(struct planning *work)
{
    const struct mesh *mesh = work->mesh;
    for (uint32_t from = 0; from < mesh->texture_count; from++)
        for (uint32_t to = 0; to < mesh->texture_count; to++) {
            if (from == to || !is_used(work, from) || !is_used(work, to)) continue;
            if (!is_near(&mesh->textures[from], &mesh->textures[to])) continue;
            work->pairs = grow(work->pairs, work->pair_count, &work->pair_capacity, sizeof *work->pairs);
            work->pairs[work->pair_count++] = (struct pair){from, to};
        }
}

static void begin(struct planning *work)
{
    const size_t count = work->mesh->texture_count;
    work->lights = grow_zeroed(count, sizeof *work->lights);
    work->light_counts = grow_zeroed(count, sizeof *work->light_counts);
    work->colours = grow_zeroed(count, sizeof *work->colours);
    work->losses = grow_zeroed(count, sizeof *work->losses);
    find_lights(work);
    for (uint32_t i = 0; i < count; i++) {
        work->steps[i] = (struct texture_step){.shows = i};
        forget_losses(work, i);
        if (!is_used(work, i)) continue;
        for (unsigned cut = 0; cut < work->mesh->textures[i].levels; cut++)
            work->colours[i][cut] = cut ? texture_cut_colours(&work->mesh->textures[i], cut)
                                        : work->mesh->textures[i].colours; /* all are kept */
        work->total_b += bytes_of(work, i);
    }
    work->total_b += TEXTURE_COLOURS * sizeof(uint16_t); /* what the last palette is filled up with, at most */
    find_pairs(work);
}

static double rms_of(double loss, double pixels)
{
    return pixels > 0 ? sqrt(loss / pixels / CHANNELS) : 0;
}

static double loss_of_step(const struct planning *work, uint32_t texture)
{
    const struct texture_step *const step = &work->steps[texture];
    if (step->has_means) return pixels_of(work, texture) * work->means[texture].error;
    return step->is_flat ? loss_flat(work, texture) : loss_as(work, texture, step->shows, step->cut);
}

static void settle(struct planning *work, struct texture_plan *plan)
{
    double loss = 0, pixels = 0;
    for (uint32_t i = 0; i < work->mesh->texture_count; i++) {
        struct texture_step *const step = &work->steps[i];
        if (!is_used(work, i)) continue;
        step->cut = work->steps[step->shows].cut;
        const double own = loss_of_step(work, i);
        step->rms = rms_of(own, pixels_of(work, i));
        loss += own, pixels += pixels_of(work, i);
    }
    plan->rms = rms_of(loss, pixels);
    plan->after_b = work->total_b;
}

static void end(struct planning *work)
{
    for (size_t i = 0; i < work->mesh->texture_count; i++)
        free(work->lights[i]);
    free(work->lights);
    free(work->light_counts);
    free(work->colours);
    free(work->losses);
    free(work->pairs);
}

bool texture_plan_make(const struct mesh *mesh, const struct texels_seen *seen, const struct texture_mean *means,
                       size_t colour_b, size_t budget_b, struct texture_plan *plan)
{
    *plan = (struct texture_plan){.steps = grow_zeroed(mesh->texture_count, sizeof *plan->steps),
                                  .before_b = texture_plan_bytes(mesh)};
    struct planning work = {.mesh = mesh, .seen = seen, .means = means, .colour_b = colour_b, .steps = plan->steps};
    begin(&work);
    while (work.total_b > budget_b && (take_next(&work) || take_next_means(&work))) {
    }
    while (work.total_b <= budget_b && give_back(&work, budget_b)) {
    }
    settle(&work, plan);
    end(&work);
    return plan->after_b <= budget_b;
}

void texture_plan_free(struct texture_plan *plan)
{
    free(plan->steps);
    *plan = (struct texture_plan){0};
}
