/* SPDX-License-Identifier: MIT
 *
 * Sources: Fell, The Unofficial Doom Specs 1.666, 1994, chapter 4-3, for what a special does; linuxdoom (p_doors.c,
 * p_plats.c) for how far, how fast and how long. Specials that shut a door, move a floor or a ceiling once, or crush,
 * are none of these: the map is shown as it begins. */
#include "levels/level_moves.h"

#include "base/choice.h"
#include "base/grow.h"
#include "levels/level_faces.h"
#include "levels/level_textures.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    DOOR_SPEED = 2,
    LIFT_SPEED = 4,
    FAST_SPEED = 8,
    DOOR_WAIT = 150,
    LIFT_WAIT = 105,
    DOOR_LINTEL = 4,
    LEAST_WAY = 8
};
static const double REST_S = 2.0; /* at the end of a round */

static enum level_doors chosen = LEVEL_DOORS_CLOSED;

void level_doors_set(enum level_doors doors)
{
    chosen = doors;
}

enum level_doors level_doors(void)
{
    return chosen;
}

bool level_doors_parse(const char *text, enum level_doors *out, struct error *err)
{
    static const char *const names[] = {
        [LEVEL_DOORS_CLOSED] = "closed", [LEVEL_DOORS_OPEN] = "open", [LEVEL_DOORS_MOVE] = "move", NULL};
    size_t index;
    if (!choice_find(&(struct choice){"--doors", "doors", choice_in_array, names}, text, &index, err)) return false;
    *out = (enum level_doors)index;
    return true;
}

/* Specials ----------------------------------------------------------------------------------- */

/* MANUAL: of the sector behind the line, whatever its tag. */
enum { MANUAL = 1, FAST = 2, LIFT = 4 };

static const struct special {
    uint8_t number, flags;
} SPECIALS[] = {{1, MANUAL},
                {26, MANUAL},
                {27, MANUAL},
                {28, MANUAL},
                {31, MANUAL},
                {32, MANUAL},
                {33, MANUAL},
                {34, MANUAL},
                {117, MANUAL | FAST},
                {118, MANUAL | FAST},
                {2, 0},
                {4, 0},
                {29, 0},
                {46, 0},
                {61, 0},
                {63, 0},
                {86, 0},
                {90, 0},
                {103, 0},
                {99, FAST},
                {105, FAST},
                {106, FAST},
                {108, FAST},
                {109, FAST},
                {111, FAST},
                {112, FAST},
                {114, FAST},
                {115, FAST},
                {133, FAST},
                {134, FAST},
                {135, FAST},
                {136, FAST},
                {137, FAST},
                {10, LIFT},
                {21, LIFT},
                {62, LIFT},
                {88, LIFT},
                {120, LIFT | FAST},
                {121, LIFT | FAST},
                {122, LIFT | FAST},
                {123, LIFT | FAST}};

static const struct special *special_of(const struct level_line *line)
{
    for (size_t i = 0; i < sizeof SPECIALS / sizeof *SPECIALS; i++)
        if (SPECIALS[i].number == line->special) return &SPECIALS[i];
    return NULL;
}

/* Heights around ----------------------------------------------------------------------------- */

struct around {
    int lowest_ceiling, lowest_floor;
};

static void look_at(const struct level *level, size_t from, size_t to, struct around *around)
{
    const struct level_sector *sector = &level->sectors[to];
    if (from == to) return;
    if (sector->ceiling < around[from].lowest_ceiling) around[from].lowest_ceiling = sector->ceiling;
    if (sector->floor < around[from].lowest_floor) around[from].lowest_floor = sector->floor;
}

/* Of each sector: what lines say lies beside it. */
static struct around *look_around(const struct level *level)
{
    struct around *around = grow_zeroed(level->sector_count, sizeof *around);
    for (size_t i = 0; i < level->sector_count; i++)
        around[i] = (struct around){INT_MAX, INT_MAX};
    for (size_t i = 0; i < level->line_count; i++) {
        const struct level_line *line = &level->lines[i];
        if (line->sides[0] == LEVEL_NO_SIDE || line->sides[1] == LEVEL_NO_SIDE) continue;
        const size_t a = level->sides[line->sides[0]].sector, b = level->sides[line->sides[1]].sector;
        look_at(level, a, b, around);
        look_at(level, b, a, around);
    }
    return around;
}

/* What has hardly anywhere to go stays, and so does the sky, and a door that is open already. */
static void set_move(const struct level_sector *sector, const struct around *around, const struct special *special,
                     struct level_move *move)
{
    const bool is_lift = special->flags & LIFT, is_fast = special->flags & FAST;
    const int rest = is_lift ? sector->floor : sector->ceiling;
    const int moved = is_lift ? around->lowest_floor : around->lowest_ceiling - DOOR_LINTEL;
    if (move->kind != MODEL_MOVES || around->lowest_ceiling == INT_MAX) return;
    if (is_lift ? moved > rest - LEAST_WAY : moved < rest + LEAST_WAY || level_is_sky(sector->ceiling_flat)) return;
    *move = (struct level_move){.kind = is_lift ? MODEL_LIFT : MODEL_DOOR,
                                .rest = rest,
                                .moved = moved,
                                .speed = is_fast   ? FAST_SPEED
                                         : is_lift ? LIFT_SPEED
                                                   : DOOR_SPEED,
                                .wait_tics = is_lift ? LIFT_WAIT : DOOR_WAIT};
}

struct level_move *level_moves_find(const struct level *level)
{
    struct level_move *moves = grow_zeroed(level->sector_count, sizeof *moves);
    struct around *around = look_around(level);
    for (size_t i = 0; i < level->line_count; i++) {
        const struct level_line *line = &level->lines[i];
        const struct special *special = special_of(line);
        if (!special || (special->flags & MANUAL && line->sides[1] == LEVEL_NO_SIDE)) continue;
        const size_t behind = special->flags & MANUAL ? level->sides[line->sides[1]].sector : level->sector_count;
        for (size_t k = 0; k < level->sector_count; k++)
            if (special->flags & MANUAL ? k == behind : line->tag && level->sectors[k].tag == line->tag)
                set_move(&level->sectors[k], &around[k], special, &moves[k]);
    }
    free(around);
    return moves;
}

void level_moves_open(const struct level_move *moves, struct level *level)
{
    for (size_t i = 0; i < level->sector_count; i++) {
        if (moves[i].kind == MODEL_DOOR) level->sectors[i].ceiling = moves[i].moved;
        if (moves[i].kind == MODEL_LIFT) level->sectors[i].floor = moves[i].moved;
    }
}

/* Movers ------------------------------------------------------------------------------------- */

uint16_t level_mover_add(struct model *model, const struct level_move *move, size_t sector, const double origin_m[3])
{
    size_t capacity = model->mover_count;
    model->movers = grow(model->movers, model->mover_count, &capacity, sizeof *model->movers);
    struct model_mover *mover = &model->movers[model->mover_count++];
    *mover = (struct model_mover){.kind = move->kind, .rest.turn = {0, 0, 0, 1}};
    memcpy(mover->rest.at_m, origin_m, sizeof mover->rest.at_m);
    snprintf(mover->name, sizeof mover->name, "%s of sector %zu", move->kind == MODEL_DOOR ? "door" : "lift", sector);
    return (uint16_t)model->mover_count;
}

static double way_s(const struct level_move *move)
{
    return fabs((double)(move->moved - move->rest)) / move->speed / LEVEL_TICS_A_S;
}

static double round_s(const struct level_move *move)
{
    return 2 * way_s(move) + (double)move->wait_tics / LEVEL_TICS_A_S + REST_S;
}

/* Off it goes at once; it waits, comes back, and rests. */
static void add_keys(struct model *model, const struct level_move *move, double length_s)
{
    struct model_mover *mover = &model->movers[move->mover - 1];
    const double there_s = way_s(move), back_s = there_s + (double)move->wait_tics / LEVEL_TICS_A_S;
    const double times_s[] = {0, there_s, back_s, back_s + there_s, length_s};
    const int slack = move->moved > move->rest ? LEVEL_MOVE_SLACK : -LEVEL_MOVE_SLACK;
    const double way_m = (double)(move->moved - move->rest + slack) / LEVEL_UNITS_A_M;
    mover->first_key = (uint32_t)model->key_count;
    mover->key_count = sizeof times_s / sizeof *times_s;
    for (size_t i = 0; i < mover->key_count; i++) {
        size_t capacity = model->key_count;
        model->keys = grow(model->keys, model->key_count, &capacity, sizeof *model->keys);
        struct model_key *key = &model->keys[model->key_count++];
        *key = (struct model_key){times_s[i], mover->rest};
        key->pose.at_m[1] += i == 1 || i == 2 ? way_m : 0;
    }
}

void level_movers_finish(struct model *model, const struct level_move *moves, size_t count)
{
    double length_s = 0;
    for (size_t i = 0; i < count; i++)
        if (moves[i].mover) length_s = fmax(length_s, round_s(&moves[i]));
    for (uint16_t mover = 1; mover <= model->mover_count; mover++)
        for (size_t i = 0; i < count; i++)
            if (moves[i].mover == mover) add_keys(model, &moves[i], length_s);
}
