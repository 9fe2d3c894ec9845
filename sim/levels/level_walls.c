/* SPDX-License-Identifier: MIT
 *
 * Which height a texture hangs from is told by a line's flags. Source: Fell, The Unofficial Doom Specs 1.666, 1994,
 * chapter 4, and the renderer of linuxdoom (r_segs.c), for what is seen where the sky is on both sides. */
#include "levels/level_walls.h"

#include <math.h>
#include <string.h>

/* Of clear texels: more than this share is nothing to be seen, as a pane. */
static const double MOSTLY_CLEAR = 0.97;

enum { OPAQUE = 0, INVISIBLE = 255 };

struct wall {
    struct level_faces *faces;
    const struct level *level;
    const struct level_line *line;
    const struct level_side *side;
    const struct level_sector *here, *beyond; /* beyond: NULL where there is nothing */
    const struct level_move *move;            /* of what is beyond; NULL: it stays */
    struct level_vertex from, to;             /* seen from the right of that way */
    double along;                             /* how far from the line's beginning, on this side, that is */
    double behind;                            /* how far behind the line it stands */
    size_t sky;
};

static int lower_of(int a, int b)
{
    return a < b ? a : b;
}

static int higher_of(int a, int b)
{
    return a > b ? a : b;
}

static bool has_texture(const char *name)
{
    return *name && strcmp(name, "-") != 0;
}

/* Walls that run along an axis are a level darker or lighter, so that corners show. */
static uint32_t light_of(const struct wall *wall)
{
    const int contrast = wall->from.y == wall->to.y ? -1 : wall->from.x == wall->to.x ? 1 : 0;
    return level_light(wall->faces->textures, wall->here->light, contrast);
}

/* hangs: the height at which the texture's first row is. */
static void add_rectangle(const struct wall *wall, int low, int high, double hangs, const struct level_paint *paint)
{
    const struct level_vertex from = wall->from, to = wall->to;
    const double length = hypot(to.x - from.x, to.y - from.y);
    const double u = wall->along + wall->side->x_offset, along = u + length;
    const double behind = length > 0 ? wall->behind / length : 0;
    const double x = -(to.y - from.y) * behind, y = (to.x - from.x) * behind;
    const double at_low = hangs - low + wall->side->y_offset, at_high = hangs - high + wall->side->y_offset;
    const struct level_corner corners[4] = {{from.x + x, from.y + y, low, u, at_low},
                                            {to.x + x, to.y + y, low, along, at_low},
                                            {to.x + x, to.y + y, high, along, at_high},
                                            {from.x + x, from.y + y, high, u, at_high}};
    if (high > low) level_face_add(wall->faces, corners, 4, paint);
}

static void add_sky(const struct wall *wall, int low, int high)
{
    add_rectangle(wall, low, high, high, &(struct level_paint){.look = wall->sky, .is_sky = true, .light = 0xFFFFFF});
}

/* Without a texture Doom shows what is behind, which is mostly the floor or ceiling there: its colour stands for it. */
static void add_plain(const struct wall *wall, int low, int high, const char *flat)
{
    if (level_is_sky(flat)) {
        add_sky(wall, low, high);
        return;
    }
    const size_t look = level_look(wall->faces->textures, LOOK_FLAT, flat);
    add_rectangle(wall, low, high, high,
                  &(struct level_paint){.look = look, .is_plain = true, .light = light_of(wall)});
}

static void add_part(const struct wall *wall, int low, int high, double hangs, const char *name, const char *flat)
{
    if (high <= low) return;
    if (!has_texture(name)) {
        add_plain(wall, low, high, flat);
        return;
    }
    const size_t look = level_look(wall->faces->textures, LOOK_WALL, name);
    add_rectangle(wall, low, high, hangs, &(struct level_paint){.look = look, .light = light_of(wall)});
}

static double height_of(const struct wall *wall, size_t look)
{
    const struct level_look *found = &wall->faces->textures->looks[look];
    return found->is_known ? found->h_px : 128;
}

static void add_whole(const struct wall *wall)
{
    const int floor = wall->here->floor, ceiling = wall->here->ceiling;
    double hangs = ceiling;
    if (has_texture(wall->side->middle) && wall->line->flags & LINE_LOWER_UNPEGGED)
        hangs = floor + height_of(wall, level_look(wall->faces->textures, LOOK_WALL, wall->side->middle));
    add_part(wall, floor, ceiling, hangs, wall->side->middle, wall->here->floor_flat);
}

/* Textures of doors and lifts that move hang from where these are at rest, so what stands still beside them goes on. */
static int rest_of(const struct wall *wall, enum model_kind kind, int height)
{
    return wall->move && wall->move->mover && wall->move->kind == kind ? wall->move->rest : height;
}

/* From one height to another of the part of a wall that hangs from the floor beyond. */
static void add_below(const struct wall *wall, int low, int high, bool is_sky)
{
    const int top = is_sky ? wall->beyond->ceiling : wall->here->ceiling;
    const double hangs = wall->line->flags & LINE_LOWER_UNPEGGED ? top : rest_of(wall, MODEL_LIFT, wall->beyond->floor);
    add_part(wall, low, high, hangs, wall->side->lower, wall->beyond->floor_flat);
}

/* Returns its upper end. */
static int add_lower(const struct wall *wall, bool is_sky)
{
    const int floor = wall->here->floor, high = lower_of(wall->beyond->floor, wall->here->ceiling);
    add_below(wall, floor, high, is_sky);
    return higher_of(floor, high);
}

/* The same of what hangs from the ceiling beyond. */
static void add_above(const struct wall *wall, int low, int high)
{
    double hangs = wall->here->ceiling;
    if (has_texture(wall->side->upper) && !(wall->line->flags & LINE_UPPER_UNPEGGED))
        hangs = rest_of(wall, MODEL_DOOR, wall->beyond->ceiling) +
                height_of(wall, level_look(wall->faces->textures, LOOK_WALL, wall->side->upper));
    add_part(wall, low, high, hangs, wall->side->upper, wall->beyond->ceiling_flat);
}

static void add_upper(const struct wall *wall, int above, bool is_sky)
{
    const int low = higher_of(wall->beyond->ceiling, above), ceiling = wall->here->ceiling;
    if (is_sky) {
        add_sky(wall, low, ceiling);
        return;
    }
    add_above(wall, low, ceiling);
}

/* The side of a door that is shut, of a lift that is up: also what the room here hides of it then, and shows when it
 * moves. A door's stands behind the line, so that it is not in one
 * plane with what is above it when it is open. */
static void add_moving(const struct wall *wall, bool is_sky)
{
    const struct level_move *move = wall->move;
    struct wall side = *wall;
    if (!move || !move->mover) return;
    wall->faces->mover = move->mover;
    side.behind = move->kind == MODEL_DOOR ? LEVEL_MOVE_SLACK : 0;
    if (move->kind == MODEL_DOOR)
        add_above(&side, move->rest, lower_of(move->moved, wall->here->ceiling));
    else
        add_below(&side, higher_of(move->moved, wall->here->floor), move->rest, is_sky);
    wall->faces->mover = 0;
}

/* Of a wall with holes. Textured, what is seen of it at all is drawn. */
static uint8_t masked_transparency(const struct level_faces *faces, const struct level_look *look)
{
    const double transparency = floor(INVISIBLE * look->clear + 0.5);
    if (!faces->is_textured) return look->clear > MOSTLY_CLEAR ? INVISIBLE : (uint8_t)transparency;
    if (look->clear <= 0 || look->clear >= 1) return look->clear > 0 ? INVISIBLE : OPAQUE;
    return (uint8_t)fmin(fmax(transparency, OPAQUE + 1), INVISIBLE - 1);
}

/* What hangs in an opening: one texture high, and no higher than the opening. Where texels are clear it has holes, or,
 * without textures, is a pane. */
static void add_masked(const struct wall *wall)
{
    if (!has_texture(wall->side->middle)) return;
    const size_t look = level_look(wall->faces->textures, LOOK_WALL, wall->side->middle);
    const struct level_look *found = &wall->faces->textures->looks[look];
    const int floor = higher_of(wall->here->floor, wall->beyond->floor);
    const int ceiling = lower_of(wall->here->ceiling, wall->beyond->ceiling);
    const int height = (int)height_of(wall, look);
    const int hangs = (wall->line->flags & LINE_LOWER_UNPEGGED ? floor + height : ceiling) + wall->side->y_offset;
    const uint8_t transparency = masked_transparency(wall->faces, found);
    if (!found->is_known || transparency == INVISIBLE) return;
    const struct level_paint paint = {.look = look, .light = light_of(wall), .transparency = transparency};
    add_rectangle(wall, higher_of(floor, hangs - height), lower_of(ceiling, hangs), hangs - wall->side->y_offset,
                  &paint);
}

static void add_side(const struct wall *wall)
{
    if (wall->here->ceiling <= wall->here->floor) return;
    if (!wall->beyond) {
        add_whole(wall);
        return;
    }
    const bool is_sky = level_is_sky(wall->here->ceiling_flat) && level_is_sky(wall->beyond->ceiling_flat);
    add_upper(wall, add_lower(wall, is_sky), is_sky);
    add_moving(wall, is_sky);
    add_masked(wall);
}

/* Lines -------------------------------------------------------------------------------------- */

struct adding {
    const struct level *level;
    const struct level_sectors *sectors;
    const struct level_move *moves; /* NULL: none */
    struct level_faces *faces;
    size_t sky;
};

static const struct level_side NO_SIDE = {.upper = "-", .lower = "-", .middle = "-"};

static const struct level_sector *sector_of(const struct adding *adding, uint32_t number)
{
    return number == LEVEL_VOID ? NULL : &adding->level->sectors[number];
}

static const struct level_move *move_of(const struct adding *adding, uint32_t number)
{
    const bool moves = adding->moves && number != LEVEL_VOID && adding->moves[number].kind != MODEL_MOVES;
    return moves ? &adding->moves[number] : NULL;
}

/* What a line says: the sector on one of its sides. */
static uint32_t said_sector(const struct level *level, const struct level_line *line, int k)
{
    return line->sides[k] == LEVEL_NO_SIDE ? LEVEL_VOID : level->sides[line->sides[k]].sector;
}

/* What there is: beside an edge to the right, and to the left. */
static void sectors_beside(const struct adding *adding, uint32_t half, uint32_t out[2])
{
    out[0] = adding->sectors->sector_of[adding->sectors->triangles.twin[half] / 3];
    out[1] = adding->sectors->sector_of[half / 3];
}

static struct level_vertex place_of(const struct adding *adding, uint32_t point)
{
    const int32_t *at = adding->sectors->triangles.points[point];
    return (struct level_vertex){at[0], at[1]};
}

static double distance(struct level_vertex a, struct level_vertex b)
{
    return hypot(b.x - a.x, b.y - a.y);
}

/* Both sides of a line, or of a part of it. A line of one side is a wall from both, whatever lies there; one of none
 * has only what has to be there. */
static void add_sides(const struct adding *adding, const struct level_line *line, const struct level_vertex ends[2],
                      const uint32_t beside[2])
{
    const struct level *level = adding->level;
    const struct level_vertex begins[2] = {level->vertices[line->from], level->vertices[line->to]};
    const bool named[2] = {line->sides[0] != LEVEL_NO_SIDE, line->sides[1] != LEVEL_NO_SIDE};
    for (int k = 0; k < 2; k++)
        if (beside[k] != LEVEL_VOID)
            add_side(&(struct wall){.faces = adding->faces,
                                    .level = level,
                                    .line = line,
                                    .side = named[k] ? &level->sides[line->sides[k]] : &NO_SIDE,
                                    .here = sector_of(adding, beside[k]),
                                    .beyond = named[0] == named[1] ? sector_of(adding, beside[1 - k]) : NULL,
                                    .move = move_of(adding, beside[1 - k]),
                                    .from = ends[k],
                                    .to = ends[1 - k],
                                    .along = distance(begins[k], ends[k]),
                                    .sky = adding->sky});
}

/* The next edge on a line; TRIANGLES_NONE: the line is over, or ends at another one. */
static uint32_t next_edge(const struct adding *adding, uint32_t from, uint32_t to)
{
    const struct triangles *triangles = &adding->sectors->triangles;
    const uint32_t half = from == to ? TRIANGLES_NONE : triangles_along(triangles, from, to);
    return half != TRIANGLES_NONE && triangles->is_fixed[half] ? half : TRIANGLES_NONE;
}

static bool is_as_said(const struct adding *adding, const struct level_line *line)
{
    const struct triangles *triangles = &adding->sectors->triangles;
    const uint32_t to = adding->sectors->points[line->to];
    uint32_t from = adding->sectors->points[line->from], beside[2];
    for (uint32_t half; (half = next_edge(adding, from, to)) != TRIANGLES_NONE;) {
        sectors_beside(adding, half, beside);
        for (int k = 0; k < 2; k++)
            if (beside[k] != said_sector(adding->level, line, k)) return false;
        from = triangles->origin[half_next(half)];
    }
    return from == to;
}

/* A line that is as it says is whole, even if others end on it. */
static void add_line(const struct adding *adding, const struct level_line *line)
{
    const struct level *level = adding->level;
    const struct triangles *triangles = &adding->sectors->triangles;
    const uint32_t to = adding->sectors->points[line->to];
    uint32_t from = adding->sectors->points[line->from];
    if (is_as_said(adding, line)) {
        const uint32_t said[2] = {said_sector(level, line, 0), said_sector(level, line, 1)};
        const struct level_vertex ends[2] = {level->vertices[line->from], level->vertices[line->to]};
        add_sides(adding, line, ends, said);
        return;
    }
    for (uint32_t half; (half = next_edge(adding, from, to)) != TRIANGLES_NONE;) {
        uint32_t beside[2];
        sectors_beside(adding, half, beside);
        const uint32_t next = triangles->origin[half_next(half)];
        const struct level_vertex ends[2] = {place_of(adding, from), place_of(adding, next)};
        add_sides(adding, line, ends, beside);
        from = next;
    }
}

/* Where sectors meet without a line. */
static void add_open(const struct adding *adding, uint32_t half)
{
    static const struct level_line none = {.sides = {LEVEL_NO_SIDE, LEVEL_NO_SIDE}};
    const struct triangles *triangles = &adding->sectors->triangles;
    const struct level_vertex ends[2] = {place_of(adding, triangles->origin[half]),
                                         place_of(adding, triangles->origin[half_next(half)])};
    uint32_t beside[2];
    sectors_beside(adding, half, beside);
    if (beside[0] != beside[1]) add_sides(adding, &none, ends, beside);
}

void level_walls_add(const struct level *level, const struct level_sectors *sectors, const struct level_move *moves,
                     size_t sky, struct level_faces *faces)
{
    const struct adding adding = {level, sectors, moves, faces, sky};
    const struct triangles *triangles = &sectors->triangles;
    for (size_t i = 0; i < level->line_count; i++)
        add_line(&adding, &level->lines[i]);
    for (uint32_t half = 0; half < triangles->half_count; half++)
        if (triangles->twin[half] != TRIANGLES_NONE && half < triangles->twin[half] && !triangles->is_fixed[half])
            add_open(&adding, half);
}
