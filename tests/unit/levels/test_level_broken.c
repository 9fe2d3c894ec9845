/* SPDX-License-Identifier: MIT
 *
 * Broken WADs: each is refused in one line that names file, lump and number, or becomes a model that is whole, with a
 * notice where something had to be made up. */
#include "levels/level_import.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"
#include "unit/levels/level_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Two sectors, a thing, all kinds of walls. */
static void make_map(void)
{
    level_begin(NULL);
    const unsigned line = level_step(24, 200);
    memcpy(level_map.sides[level_map.lines[line][5]].names[2], "GRATE\0\0\0", 8);
    wad_thing(&level_map, 64, 64, 0, 1);
}

static void make(void)
{
    make_map();
    level_save("MAP01");
}

static void assert_refused(const char *reason)
{
    struct model model;
    struct error err = {""};
    wad_save(&level_wad, "a.wad");
    if (level_import("a.wad:MAP01", true, &model, &err)) fail_msg("not refused: %s", reason);
    assert_string_equal(err.text, reason);
    assert_int_equal(model.face_count, 0);
    assert_null(model.points);
}

static void assert_noticed(const char *notice)
{
    struct model model;
    struct error err = {""};
    wad_save(&level_wad, "a.wad");
    if (!level_import("a.wad:MAP01", true, &model, &err)) fail_msg("%s", err.text);
    assert_string_equal(model.notice, notice);
    model_free(&model);
}

static void assert_model_is_whole(const struct model *model)
{
    assert_true(model->face_count > 0);
    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        assert_true(face->count >= 3 && face->first + face->count <= model->corner_count);
        assert_true(face->picture <= model->picture_count);
        for (uint32_t k = 0; k < face->count; k++) {
            const uint32_t point = model->corners[face->first + k];
            assert_true(point < model->point_count);
            for (int axis = 0; axis < 3; axis++)
                assert_true(fabs(model->points[point][axis]) <= 1024);
            if (face->picture) assert_true(isfinite(model->uvs[point][0]) && isfinite(model->uvs[point][1]));
        }
    }
    for (size_t i = 0; i < model->picture_count; i++) {
        assert_true(model->pictures[i].pixels && model->pictures[i].faces);
        assert_true(model->pictures[i].w_px <= TEXTURE_SIDE_MAX_PX && model->pictures[i].h_px <= TEXTURE_SIDE_MAX_PX);
    }
}

static void assert_refused_or_whole(void)
{
    struct model model;
    struct error err = {""};
    wad_save(&level_wad, "a.wad");
    if (level_import("a.wad:MAP01", true, &model, &err)) {
        assert_model_is_whole(&model);
    } else {
        assert_true(strncmp(err.text, "a.wad: ", 7) == 0 || strncmp(err.text, "MAP01: ", 7) == 0);
        assert_int_equal(model.face_count, 0);
    }
    model_free(&model);
}

/* The entry of a lump in the directory. */
static uint8_t *entry_of(const char *name)
{
    for (size_t i = 0; i < level_wad.count; i++)
        if (strncmp(level_wad.lumps[i].name, name, 8) == 0)
            return level_wad.bytes + level_wad.size_b - 16 * (level_wad.count - i);
    fail_msg("no lump %s", name);
    return NULL;
}

static uint8_t *bytes_of(const char *name)
{
    const uint8_t *entry = entry_of(name);
    return level_wad.bytes + (entry[0] | entry[1] << 8 | entry[2] << 16);
}

static void set_size(const char *name, unsigned size_b)
{
    uint8_t *entry = entry_of(name);
    for (int i = 0; i < 4; i++)
        entry[4 + i] = (uint8_t)(size_b >> 8 * i);
}

/* -------------------------------------------------------------------------------------------- */

static void files_that_are_none_are_refused(void **state)
{
    (void)state;
    make();
    level_wad.bytes[0] = 'X';
    assert_refused("a.wad: is no WAD: it begins with neither IWAD nor PWAD");
    make();
    level_wad.size_b--;
    assert_refused("a.wad: truncated, or no WAD: its directory of 19 lumps is not within the file");
    make();
    level_wad.size_b = 11;
    assert_refused("a.wad: is no WAD: it begins with neither IWAD nor PWAD");
}

static void lumps_that_are_missing_or_cut_short_are_named(void **state)
{
    (void)state;
    make();
    memcpy(entry_of("SECTORS") + 8, "SECTOR?", 7);
    assert_refused("a.wad: MAP01: there is no lump SECTORS");
    make();
    set_size("LINEDEFS", 13);
    assert_refused("a.wad: MAP01: lump LINEDEFS: truncated: its 13 bytes are no records of 14");
    make();
    set_size("VERTEXES", 0);
    assert_refused("a.wad: MAP01: lump VERTEXES: it is empty");
    make();
    set_size("SIDEDEFS", 0x7FFFFFFF);
    assert_refused("a.wad: lump SIDEDEFS: truncated: it ends beyond the end of the file");
    make();
    memcpy(entry_of("PLAYPAL") + 8, "PLAYPA?", 7);
    assert_refused("a.wad: there is no lump PLAYPAL in it; a PWAD is read over its IWAD: IWAD.wad+PWAD.wad");
    make();
    set_size("PLAYPAL", 767);
    assert_refused("a.wad: lump PLAYPAL: truncated: 767 bytes, a palette has 768");
    make();
    set_size("TEXTURE1", 19);
    assert_refused("a.wad: lump TEXTURE1: truncated: it ends within its list of 4 textures");
    make();
    set_size("TEXTURE1", 100);
    assert_refused("a.wad: lump TEXTURE1: texture 2 is not within it");
    make();
    bytes_of("TEXTURE1")[20 + 20] = 13;
    assert_refused("a.wad: lump TEXTURE1: texture 0: its 13 patches are not within it");
}

static void indices_out_of_range_are_refused_by_their_number(void **state)
{
    (void)state;
    make_map();
    level_map.lines[2][1] = 6;
    level_save("MAP01");
    assert_refused("a.wad: MAP01: LINEDEFS 2: its vertex is number 6, of 6");
    make_map();
    level_map.lines[6][6] = 8;
    level_save("MAP01");
    assert_refused("a.wad: MAP01: LINEDEFS 6: its side is number 8, of 8");
    make_map();
    level_map.lines[1][5] = WAD_NO_SIDE;
    level_save("MAP01");
    assert_refused("a.wad: MAP01: LINEDEFS 1: it has no right side");
    make_map();
    level_map.sides[5].sector = 2;
    level_save("MAP01");
    assert_refused("a.wad: MAP01: SIDEDEFS 5: its sector is number 2, of 2");
}

static void maps_of_other_formats_and_without_space_are_refused(void **state)
{
    (void)state;
    make_map();
    wad_begin(&level_wad, "IWAD");
    wad_write_map(&level_wad, "MAP01", &level_map);
    wad_lump(&level_wad, "BEHAVIOR", "ACS", 4);
    wad_end(&level_wad);
    assert_refused("a.wad: MAP01: is of Hexen's format, which is not read; only Doom's is");
    wad_begin(&level_wad, "IWAD");
    wad_lump(&level_wad, "MAP01", NULL, 0);
    wad_lump(&level_wad, "TEXTMAP", "namespace", 9);
    wad_end(&level_wad);
    assert_refused("a.wad: MAP01: is of UDMF, which is not read");
    wad_begin(&level_wad, "IWAD");
    wad_write_map(&level_wad, "E1M1", &level_map);
    wad_end(&level_wad);
    assert_refused("a.wad: there is no map MAP01 in it; `limner wad` lists those that are");
    level_begin(NULL);
    wad_room(&level_map, 0, 0, 64, wad_sector(&level_map, 8, 8, 0, "FLOOR", "CEIL"));
    level_save("MAP01");
    assert_refused("a.wad: MAP01: SECTORS: none of them has a height");
    for (size_t i = 0; i < level_map.vertex_count; i++)
        level_map.vertices[i][0] = 0;
    level_save("MAP01");
    assert_refused("a.wad: MAP01: LINEDEFS: its lines enclose nothing");
}

static void textures_that_are_missing_or_broken_are_a_notice(void **state)
{
    (void)state;
    make_map();
    memcpy(level_map.sides[0].names[2], "NOWHERE\0", 8);
    level_save("MAP01");
    assert_noticed("textures that are missing: 1, NOWHERE among them; grey instead");
    make();
    memcpy(entry_of("PWALL") + 8, "PWAL?", 5);
    assert_noticed("parts of textures that are broken or missing: 1, PWALL of WALL among them");
    make();
    set_size("PWALL", 300);
    assert_noticed("parts of textures that are broken or missing: 1, PWALL of WALL among them");
    make();
    set_size("FLOOR", 4095);
    assert_noticed("textures that are missing: 1, FLOOR among them; grey instead\nparts of textures that are broken or "
                   "missing: 1, FLOOR of FLOOR among them");
}

static void lines_that_cross_and_sectors_that_are_open_are_a_notice(void **state)
{
    (void)state;
    make_map();
    level_map.line_count--; /* the line between the sectors */
    level_save("MAP01");
    assert_noticed("lines that name a sector which is not there: 3, LINEDEFS 3 among them");
    make_map();
    level_map.line_count -= 2; /* and the wall beside it */
    level_save("MAP01");
    assert_refused_or_whole();
    make_map();
    level_border(0, 4, 0, 0);
    level_border(1, 5, 0, 0);
    level_save("MAP01");
    assert_noticed("lines that cross others: 2, LINEDEFS 7 among them; floors follow the others");
}

static void files_cut_anywhere_are_refused_or_whole(void **state)
{
    (void)state;
    make();
    const size_t whole_b = level_wad.size_b;
    for (size_t size_b = 1; size_b < whole_b; size_b += size_b < 64 ? 1 : 1 + size_b / 16) {
        level_wad.size_b = size_b;
        assert_refused_or_whole();
    }
    level_wad.size_b = whole_b;
    for (size_t i = 0; i < level_wad.count; i++)
        for (unsigned size_b = 0; size_b < level_wad.lumps[i].size_b; size_b += 1 + size_b / 3) {
            make();
            set_size(level_wad.lumps[i].name, size_b);
            assert_refused_or_whole();
        }
}

/* A few bytes anywhere, mostly in the map and the lists, which are short. */
static void bytes_changed_anywhere_are_refused_or_whole(void **state)
{
    (void)state;
    struct random random = {5};
    static const char *const names[] = {"THINGS", "LINEDEFS", "SIDEDEFS", "VERTEXES", "SECTORS",
                                        "PNAMES", "TEXTURE1", "PWALL",    "PGRATE"};
    for (int run = 0; run < effort(800); run++) {
        make();
        for (int64_t i = random_in(&random, 1, 4); i; i--) {
            const char *name = names[random_in(&random, 0, 8)];
            const uint8_t *entry = entry_of(name);
            const int64_t size_b = entry[4] | entry[5] << 8;
            uint8_t *at = bytes_of(name) + random_in(&random, 0, size_b - 1);
            *at = (uint8_t)(random_in(&random, 0, 1) ? random_in(&random, 0, 255) : *at + random_in(&random, -2, 2));
        }
        if (random_in(&random, 0, 9) == 0)
            entry_of(names[random_in(&random, 0, 8)])[random_in(&random, 0, 7)] = (uint8_t)random_in(&random, 0, 255);
        assert_refused_or_whole();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_that_are_none_are_refused),
        cmocka_unit_test(lumps_that_are_missing_or_cut_short_are_named),
        cmocka_unit_test(indices_out_of_range_are_refused_by_their_number),
        cmocka_unit_test(maps_of_other_formats_and_without_space_are_refused),
        cmocka_unit_test(textures_that_are_missing_or_broken_are_a_notice),
        cmocka_unit_test(lines_that_cross_and_sectors_that_are_open_are_a_notice),
        cmocka_unit_test(files_cut_anywhere_are_refused_or_whole),
        cmocka_unit_test(bytes_changed_anywhere_are_refused_or_whole),
    };
    return cmocka_run_group_tests(tests, level_enter, level_leave);
}
