/* SPDX-License-Identifier: MIT
 *
 * Joinery and masonry of the house. Parts that stand against a wall leave their back out; beams
 * and bars leave out the ends that meet a wall. Flat shapes lie a few millimetres before a surface. */
#include "demo_joinery.h"
#include "demo_shape.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* A flat shape some millimetres before a surface: panels of doors, rugs, what is seen far away.
 * Its outline is convex, in the plane across an axis: 0: z and y, 1: x and z, 2: x and y. */
struct cutout {
    int axis, at_mm;
    int facing; /* +1 or -1 along the axis */
    int material;
    int count;
    int outline_mm[6][2];
};

static const struct cutout cutouts[] = {
    /* front door and its panels */
    {2, 9995, -1, GREEN_PAINT, 4, {{400, 10}, {1300, 10}, {1300, 2150}, {400, 2150}}},
    {2, 9990, -1, OAK_DARK, 4, {{500, 150}, {810, 150}, {810, 950}, {500, 950}}},
    {2, 9990, -1, OAK_DARK, 4, {{890, 150}, {1200, 150}, {1200, 950}, {890, 950}}},
    {2, 9990, -1, OAK_DARK, 4, {{500, 1050}, {810, 1050}, {810, 2030}, {500, 2030}}},
    {2, 9990, -1, OAK_DARK, 4, {{890, 1050}, {1200, 1050}, {1200, 2030}, {890, 2030}}},
    /* door on the landing */
    {0, 7445, -1, OAK, 4, {{5150, 1895}, {5900, 1895}, {5900, 3790}, {5150, 3790}}},
    /* rugs in the bedchamber and the library */
    {1, 4, 1, RED_CLOTH, 4, {{8300, 6900}, {10250, 6650}, {10450, 8100}, {8500, 8350}}},
    {1, 7, 1, BLUE_CLOTH, 4, {{8450, 7018}, {9297, 6909}, {9453, 8091}, {8606, 8200}}},
    {1, 7, 1, BLUE_CLOTH, 4, {{9297, 6909}, {10144, 6800}, {10300, 7982}, {9453, 8091}}},
    {1, 10, 1, YELLOW_CLOTH, 4, {{8880, 7560}, {9350, 6990}, {9880, 7430}, {9410, 8000}}},
    {1, 13, 1, RED_CLOTH, 4, {{9010, 7550}, {9360, 7110}, {9750, 7440}, {9400, 7880}}},
    {1, 4, 1, BLUE_CLOTH, 4, {{6250, 1500}, {7900, 1500}, {7900, 3700}, {6250, 3700}}},
    {1, 7, 1, RED_CLOTH, 4, {{6430, 1680}, {7720, 1680}, {7720, 2600}, {6430, 2600}}},
    {1, 7, 1, RED_CLOTH, 4, {{6430, 2600}, {7720, 2600}, {7720, 3520}, {6430, 3520}}},
    {1, 10, 1, YELLOW_CLOTH, 4, {{7075, 1900}, {7500, 2600}, {7075, 3300}, {6650, 2600}}},
    {1, 13, 1, BLUE_CLOTH, 4, {{7075, 2060}, {7400, 2600}, {7075, 3140}, {6750, 2600}}},
    /* skies are hazy low down: street, west, north */
    {2, 12395, -1, SKY_LOW, 4, {{-890, -290}, {10190, -290}, {10190, 2000}, {-890, 2000}}},
    {0, -1895, 1, SKY_LOW, 4, {{5210, -290}, {9790, -290}, {9790, 1900}, {5210, 1900}}},
    {2, -1995, 1, SKY_LOW, 4, {{610, -290}, {12290, -290}, {12290, 2000}, {610, 2000}}},
    /* across the street */
    {2, 12390, -1, FAR_TREE, 5, {{5000, -290}, {6600, -290}, {6800, 1300}, {5900, 1900}, {4900, 1400}}},
    {2, 12380, -1, FAR_HOUSE, 4, {{1500, -290}, {2900, -290}, {2900, 1900}, {1500, 1900}}},
    {2, 12380, -1, FAR_ROOF, 3, {{1500, 1900}, {2900, 1900}, {2200, 2750}}},
    {2, 12380, -1, FAR_HOUSE2, 4, {{2900, -290}, {4300, -290}, {4300, 1600}, {2900, 1600}}},
    {2, 12380, -1, FAR_ROOF, 4, {{2900, 1600}, {4300, 1600}, {4100, 2200}, {3100, 2200}}},
    {2, 12380, -1, FAR_HOUSE, 4, {{7400, -290}, {8700, -290}, {8700, 1700}, {7400, 1700}}},
    {2, 12380, -1, FAR_ROOF, 3, {{7400, 1700}, {8700, 1700}, {8050, 2500}}},
    /* in the west */
    {0, -1890, 1, FAR_HOUSE, 4, {{6900, 900}, {7600, 900}, {7600, 1700}, {6900, 1700}}},
    {0, -1890, 1, FAR_ROOF, 3, {{6800, 1700}, {7700, 1700}, {7250, 2150}}},
    {0, -1880, 1, FAR_TREE, 6, {{5210, -290}, {9790, -290}, {9790, 1250}, {8600, 1500}, {7000, 1400}, {5210, 1100}}},
    /* the gardens */
    {2, -1990, 1, FAR_TREE, 5, {{1400, -290}, {3100, -290}, {3000, 1700}, {2200, 2100}, {1300, 1600}}},
    {2, -1980, 1, FAR_HOUSE2, 4, {{6300, 600}, {7200, 600}, {7200, 1900}, {6300, 1900}}},
    {2, -1980, 1, FAR_ROOF, 3, {{6200, 1900}, {7300, 1900}, {6750, 2450}}},
    {2, -1970, 1, FAR_HEDGE, 4, {{610, -290}, {12290, -290}, {12290, 1200}, {610, 1350}}},
    /* clouds over the court */
    {2,
     11590,
     -1,
     SKY_CLOUD,
     6,
     {{11300, 3700}, {12900, 3650}, {13500, 3850}, {12700, 4150}, {12000, 4200}, {11500, 4000}}},
    {0, 15290, -1, SKY_CLOUD, 6, {{6000, 3900}, {8200, 3850}, {8800, 4050}, {8000, 4400}, {7000, 4450}, {6300, 4200}}},
};

static struct vec3 outline_point(int axis, int at_mm, const int outline_mm[2])
{
    double at = at_mm / 1000.0, a = outline_mm[0] / 1000.0, b = outline_mm[1] / 1000.0;
    if (axis == 0) return (struct vec3){at, b, a};
    if (axis == 1) return (struct vec3){a, at, b};
    return (struct vec3){a, b, at};
}

static void add_cutouts(struct soup *soup)
{
    for (size_t i = 0; i < COUNT(cutouts); i++) {
        const struct cutout *cutout = &cutouts[i];
        struct vec3 outline[6];
        /* counter-clockwise in the table is so seen along -axis for axis 2, along +axis for the others */
        bool as_is = (cutout->axis == 2) == (cutout->facing > 0);
        for (int j = 0; j < cutout->count; j++)
            outline[as_is ? j : cutout->count - 1 - j] =
                outline_point(cutout->axis, cutout->at_mm, cutout->outline_mm[j]);
        soup_add(soup, outline, cutout->count, cutout->material);
    }
}

/* How far a doorway's posts and lintel stand out from the wall. */
enum { POST_MM = 30, LINTEL_MM = 50 };

/* The frame round one side of a doorway: two posts and a lintel. The lining covers the posts' inner
 * sides. */
static void door_case(struct soup *soup, struct frame frame, int width_mm, int height_mm, int material)
{
    int in = width_mm / 2, out = in + 100;
    struct box parts[] = {
        {{-out, 0, 0}, {-in, height_mm, POST_MM}, material, LEG | NO_BACK | NO_RIGHT, 0},
        {{in, 0, 0}, {out, height_mm, POST_MM}, material, LEG | NO_BACK | NO_LEFT, 0},
        {{-out - 20, height_mm, 0}, {out + 20, height_mm + 110, LINTEL_MM}, material, NO_BACK | NO_TOP, 0},
    };
    for (size_t i = 0; i < COUNT(parts); i++)
        shape_box(soup, &frame, &parts[i]);
}

/* The boards at the sides of a passage of some width, height and depth behind the frame. They reach
 * from post to post in one piece: the posts' inner sides alone would be thinner than a pixel to
 * whoever walks towards them. */
static void door_lining(struct soup *soup, const struct frame *frame, const int size_mm[3], int material)
{
    double in = size_mm[0] / 2.0, top = size_mm[1], near = POST_MM, far = -size_mm[2] - POST_MM;
    const double left[4][3] = {{-in, 0, near}, {-in, 0, far}, {-in, top, far}, {-in, top, near}};
    const double right[4][3] = {{in, 0, far}, {in, 0, near}, {in, top, near}, {in, top, far}};
    shape_quad(soup, frame, left, material);
    shape_quad(soup, frame, right, material);
}

int doorway_axis(const struct space *doorway)
{
    return doorway->hi_mm[0] - doorway->lo_mm[0] < doorway->hi_mm[2] - doorway->lo_mm[2] ? 0 : 2;
}

void joinery_doorway(struct soup *soup, const struct space *doorway)
{
    const int *lo = doorway->lo_mm, *hi = doorway->hi_mm;
    int axis = doorway_axis(doorway), across = 2 - axis;
    const int size_mm[3] = {hi[across] - lo[across], hi[1], hi[axis] - lo[axis]};
    double x = (lo[0] + hi[0]) / 2.0, z = (lo[2] + hi[2]) / 2.0;
    struct frame near = axis ? frame_at(x, 0, hi[2], 0) : frame_at(hi[0], 0, z, 90);
    struct frame far = axis ? frame_at(x, 0, lo[2], 180) : frame_at(lo[0], 0, z, -90);
    door_case(soup, near, size_mm[0], size_mm[1], doorway->wall);
    door_case(soup, far, size_mm[0], size_mm[1], doorway->wall);
    door_lining(soup, &near, size_mm, doorway->wall);
}

void joinery_window(struct soup *soup, const struct window *window)
{
    struct frame frame = window_frame(window);
    int width_mm = window_width_mm(window), height_mm = window_height_mm(window);
    for (int i = 0; i < window->columns; i++) {
        int left = width_mm * i / window->columns - width_mm / 2 + (i ? BAR_MM / 2 : 0);
        int right = width_mm * (i + 1) / window->columns - width_mm / 2 - (i + 1 < window->columns ? BAR_MM / 2 : 0);
        struct box upright = {{right, 0, BAR_AT_MM}, {right + BAR_MM, height_mm, BAR_AT_MM}, WHITEWASH, ~NO_FRONT, 0};
        if (i + 1 < window->columns) shape_box(soup, &frame, &upright);
        for (int j = 1; j < window->rows; j++) {
            int y = height_mm * j / window->rows - BAR_MM / 2;
            struct box rail = {{left, y, BAR_AT_MM}, {right, y + BAR_MM, BAR_AT_MM}, WHITEWASH, ~NO_FRONT, 0};
            shape_box(soup, &frame, &rail);
        }
    }
}

/* Ceiling beams of a room, in pieces so that the light on them can change along their length. */
struct beams {
    bool along_x;
    int from_mm, to_mm, ceiling_mm; /* ends, underside of the ceiling */
    int first_mm, step_mm, count;   /* middles */
    int width_mm, depth_mm, pieces;
    int material;
};

static const struct beams all_beams[] = {
    {true, 0, 4400, 3200, 5700, 1180, 4, 180, 200, 2, OAK},  /* hall */
    {false, 0, 4800, 3400, 680, 1010, 5, 180, 220, 2, OAK},  /* studio */
    {false, 0, 4800, 2900, 9290, 1177, 4, 160, 180, 2, OAK}, /* kitchen */
    {true, 7700, 10900, 2800, 6700, 1300, 3, 140, 140, 2, OAK_PALE},
};

static void add_beams(struct soup *soup, const struct beams *beams)
{
    int length_mm = (beams->to_mm - beams->from_mm) / beams->pieces;
    for (int i = 0; i < beams->count; i++)
        for (int piece = 0; piece < beams->pieces; piece++) {
            int middle = beams->first_mm + i * beams->step_mm, start = beams->from_mm + piece * length_mm;
            int end = piece + 1 < beams->pieces ? start + length_mm : beams->to_mm;
            int low = beams->ceiling_mm - beams->depth_mm, half = beams->width_mm / 2;
            struct frame world = frame_at(0, 0, 0, 0);
            struct box along_x = {{start, low, middle - half},
                                  {end, beams->ceiling_mm, middle + half},
                                  beams->material,
                                  NO_ENDS | NO_TOP,
                                  0};
            struct box along_z = {{middle - half, low, start},
                                  {middle + half, beams->ceiling_mm, end},
                                  beams->material,
                                  NO_FRONT | NO_BACK | NO_TOP,
                                  0};
            shape_box(soup, &world, beams->along_x ? &along_x : &along_z);
        }
}

enum { STAIR_X_MM = 5330, STAIR_BACK_MM = 5050, STAIR_FRONT_MM = 6000, STAIR_END_MM = 7450 };
enum { STEPS = 9, RISE_MM = 210, TREAD_MM = 190 };

static void add_steps(struct soup *soup)
{
    struct frame world = frame_at(0, 0, 0, 0);
    for (int i = 0; i < STEPS; i++) {
        int left = STAIR_X_MM + i * TREAD_MM, right = i + 1 < STEPS ? left + TREAD_MM : STAIR_END_MM;
        struct box step = {{left, i * RISE_MM, STAIR_BACK_MM},
                           {right, (i + 1) * RISE_MM, STAIR_FRONT_MM},
                           OAK,
                           NO_RIGHT | NO_BOTTOM | NO_BACK | NO_FRONT,
                           0};
        struct box side = {
            {left, 0, STAIR_BACK_MM}, {right, (i + 1) * RISE_MM, STAIR_FRONT_MM}, GREEN_PAINT, ~NO_FRONT, 0};
        shape_box(soup, &world, &step);
        shape_box(soup, &world, &side);
    }
}

/* Balusters and rail are boxes in a frame sheared along the flight, so that their ends slope with
 * it while their sides stand upright. */
static void add_banister(struct soup *soup)
{
    struct frame flight = frame_at(STAIR_X_MM, RISE_MM, STAIR_FRONT_MM - 50, 0);
    struct frame landing = frame_at(STAIR_X_MM + (STEPS - 1) * TREAD_MM, STEPS * RISE_MM, STAIR_FRONT_MM - 50, 0);
    flight.right.y = (double)RISE_MM / TREAD_MM;
    for (int i = 0; i < STEPS - 1; i++) {
        int middle = i * TREAD_MM + TREAD_MM / 2;
        int foot = -RISE_MM / 2 + 20; /* on the tread below the line of the nosings, clear of it as it slopes */
        struct box baluster = {{middle - 16, foot, -16}, {middle + 16, 820, 16}, OAK_PALE, LEG, 0};
        shape_box(soup, &flight, &baluster);
    }
    struct box rail = {{-60, 820, -35}, {(STEPS - 1) * TREAD_MM, 880, 35}, OAK_DARK, NO_RIGHT, 0};
    shape_box(soup, &flight, &rail);
    struct box newel = {{-140, 0, -45}, {-60, 1040, 45}, OAK_DARK, STANDING, 0};
    struct frame foot = frame_at(STAIR_X_MM, 0, STAIR_FRONT_MM - 50, 0);
    shape_box(soup, &foot, &newel);
    struct box rest[] = {
        {{0, 0, -45}, {80, 960, 45}, OAK_DARK, STANDING, 0},
        {{80, 820, -35}, {598, 880, 35}, OAK_DARK, NO_LEFT, 0},
        {{230, 0, -16}, {262, 820, 16}, OAK_PALE, LEG, 0},
        {{440, 0, -16}, {472, 820, 16}, OAK_PALE, LEG, 0},
    };
    for (size_t i = 0; i < COUNT(rest); i++)
        shape_box(soup, &landing, &rest[i]);
}

/* In a frame at the middle of the hearth, at the wall, facing the room. */
static const struct box fireplace[] = {
    {{-900, 0, 0}, {-700, 1350, 140}, STONE, LEG | NO_BACK, 0},
    {{700, 0, 0}, {900, 1350, 140}, STONE, LEG | NO_BACK, 0},
    {{-950, 1350, 0}, {950, 1560, 340}, OAK, NO_BACK, 0},
    {{-900, 1560, 0}, {900, 2100, 290}, WHITEWASH, NO_BACK | LEG, 70},
    {{-830, 2100, 0}, {830, 2900, 220}, WHITEWASH, NO_BACK | LEG, 70},
    {{-820, 0, 140}, {820, 40, 620}, SLATE, NO_BACK | STANDING, 0},
    {{-330, 0, -330}, {-300, 95, 40}, EBONY, STANDING, 0},
    {{300, 0, -330}, {330, 95, 40}, EBONY, STANDING, 0},
};

/* In a frame turned by 45 degrees: an edge towards the room shows two sides broadly, and none edge-on. */
static const struct turned flames[] = {
    {-99, -85, FLAME, 4, 2, false, {{85, 210}, {0, 520}}},
    {28, 14, FLAME, 4, 2, false, {{105, 210}, {0, 680}}},
    {106, 134, EMBER, 4, 2, false, {{75, 210}, {0, 450}}},
    {0, 0, EMBER, 6, 2, false, {{240, 2}, {150, 60}}},
};

static void add_fireplace(struct soup *soup)
{
    struct frame frame = frame_at(13400, 0, 2600, -90);
    struct frame fire = frame_turn(frame_move(frame, 0, 0, -200), 45);
    struct frame log = frame_turn(frame_move(frame, 0, 96, -260), 3);
    struct frame log2 = frame_turn(frame_move(frame, 0, 96, -90), -2);
    struct box wood = {{-380, 0, -55}, {380, 100, 55}, OAK_DARK, 0, 0};
    for (size_t i = 0; i < COUNT(fireplace); i++)
        shape_box(soup, &frame, &fireplace[i]);
    for (size_t i = 0; i < COUNT(flames); i++)
        shape_turned(soup, &fire, &flames[i]);
    shape_box(soup, &log, &wood);
    shape_box(soup, &log2, &wood);
}

/* Two roof slopes rise from the eaves over the court to the edges of its sky, and meet in a valley. */
static void add_roofs(struct soup *soup)
{
    enum { PARTS = 3 };
    struct frame world = frame_at(0, 0, 0, 0);
    for (int i = 0; i < PARTS; i++) {
        double z0 = 5150 + 5200.0 * i / PARTS, z1 = 5150 + 5200.0 * (i + 1) / PARTS, z0_high = i ? z0 : 4300;
        double x0 = 11250 + 4050.0 * i / PARTS, x1 = 11250 + 4050.0 * (i + 1) / PARTS, x0_high = i ? x0 : 10400;
        const double west[4][3] = {{11250, 3100, z1}, {11250, 3100, z0}, {10400, 4100, z0_high}, {10400, 4100, z1}};
        const double north[4][3] = {{x0, 3100, 5150}, {x1, 3100, 5150}, {x1, 4100, 4300}, {x0_high, 4100, 4300}};
        shape_quad(soup, &world, west, ROOFING);
        shape_quad(soup, &world, north, ROOFING);
    }
}

void joinery_fixtures(struct soup *soup)
{
    for (size_t i = 0; i < COUNT(all_beams); i++)
        add_beams(soup, &all_beams[i]);
    add_cutouts(soup);
    add_steps(soup);
    add_banister(soup);
    add_fireplace(soup);
    add_roofs(soup);
}
