/* SPDX-License-Identifier: MIT
 *
 * What stands and hangs where, room by room: things, pictures, cloth, books and vines. Positions
 * in millimetres; yaw in degrees, 0 faces south, 90 east, 180 north, -90 west. */
#include "demo_rooms.h"
#include "demo_pictures.h"
#include "demo_things.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

struct standing {
    enum thing_id thing;
    int x_mm, y_mm, z_mm;
    double yaw_deg;
};

static const struct standing furniture[] = {
    /* hall */
    {TABLE, 640, 0, 7500, 90},
    {JUG, 560, 770, 7300, 30},
    {BOWL, 720, 770, 7570, 45},
    {OPEN_BOOK, 600, 770, 7900, 70},
    {CHAIR, 1480, 0, 7850, 238},
    {CHAIR, 520, 0, 6420, 20},
    {CHEST, 3430, 0, 5330, 0},
    {VASE, 3700, 540, 5320, 0},
    {CHANDELIER, 2200, 2430, 7470, 27},
    {POT_PLANT, 3980, 0, 9560, 15},

    /* studio */
    {LONG_TABLE, 2500, 0, 620, 0},
    {BUST, 1880, 770, 560, 15},
    {STOOL, 3420, 0, 3480, 10},
    {CHAIR, 4560, 0, 780, -32},
    {CHEST, 380, 0, 1150, 90},
    {BOTTLES, 380, 540, 1150, 80},
    {PAINTS, 2420, 770, 720, -14},
    {BRUSHES, 2800, 770, 560, 0},
    {BOWL, 3150, 770, 640, 0},
    {POT_PLANT, 330, 0, 320, 40},
    /* library */
    {DESK, 7050, 0, 480, 0},
    {DESK_LAMP, 7480, 765, 420, 0},
    {OPEN_BOOK, 6960, 765, 560, 8},
    {CHAIR, 6950, 0, 1160, 172},
    {GLOBE, 5990, 0, 1250, 25},
    {ARMCHAIR, 6380, 0, 4250, 138},
    /* kitchen */
    {LONG_TABLE, 10850, 0, 1280, 3},
    {LOAF, 10480, 770, 1220, 0},
    {JUG, 11000, 770, 1350, 30},
    {BOWL, 11350, 770, 1200, 0},
    {BENCH, 10800, 0, 1980, 1},
    {DRESSER, 9980, 0, 4560, 180},
    {PLATES, 9980, 0, 4560, 180},
    {PANS, 12550, 1900, 0, 0},
    {STOOL, 12550, 0, 1450, 0},
    {CAT, 12250, 0, 2950, 148},
    {BARREL, 13060, 0, 4430, 14},
    /* bedchamber */
    {BED, 9720, 0, 5760, 0},
    {SIDE_TABLE, 10560, 0, 9420, -90},
    {CANDLE, 10560, 730, 9270, 0},
    {CUPBOARD, 7940, 0, 9060, 90},
    {CHEST, 8060, 0, 6320, 90},
    {MIRROR, 10900, 1250, 8480, -90},
    /* stairs */
    {CLOCK, 4795, 0, 8650, 90},
    /* court */
    {BENCH, 12750, 0, 9720, 180},
    {TUB_TREE, 14180, 0, 5720, 0},
    {TUB_TREE, 11720, 0, 9450, 40},
    {PUMP, 14230, 0, 7050, -90},
    {BUCKET, 13650, 0, 7450, 0},
    {POT_PLANT, 14250, 0, 8900, 10},
    {POT_PLANT, 13850, 0, 9550, 60},
    {TREE, 12230, 2200, 10630, 30},
};

struct hanging {
    enum picture_id picture;
    int x_mm, y_mm, z_mm;
    double yaw_deg;
    int width_mm, height_mm;
};

static const struct hanging pictures[] = {
    {SEASCAPE, 3430, 1720, 5050, 0, 1100, 760},        {MAP, 4400, 1650, 6050, -90, 1300, 950},
    {WINDMILL, 820, 1700, 5050, 0, 860, 640},          {PORTRAIT, 0, 1800, 2500, 90, 760, 960},
    {MINIATURE_LADY, 3700, 1650, 4800, 180, 260, 330}, {MINIATURE_LORD, 4250, 1700, 4800, 180, 260, 330},
    {MINIATURE_LADY, 4800, 1650, 4800, 180, 260, 330}, {STILL_LIFE, 5400, 1750, 1100, -90, 900, 700},
    {SEASCAPE, 7700, 1750, 6200, 90, 760, 560},        {STILL_LIFE, 4650, 1770, 6500, 90, 600, 500},
    {WINDMILL, 7450, 1700, 8900, -90, 900, 700},
};

struct hung_cloth {
    int x_mm, y_mm, z_mm;
    double yaw_deg;
    struct drape drape;
};

static const struct hung_cloth cloths[] = {
    /* studio: a curtain in the north-east corner */
    {4430, 20, 60, 0, {900, 2900, 110, 4, RED_CLOTH, true}},
    /* bed: at the back, drawn to both ends of the front */
    {8750, 430, 5140, 0, {1940, 1610, 50, 6, BLUE_CLOTH, false}},
    {8640, 30, 6385, 0, {420, 2020, 40, 2, BLUE_CLOTH, true}},
    {10390, 30, 6385, 0, {380, 2020, 40, 2, BLUE_CLOTH, true}},
};

/* A climbing plant on a wall: leaves parallel to it, each at its own distance, within an ellipse. */
struct vine {
    int x_mm, y_mm, z_mm; /* middle, on the wall */
    double yaw_deg;
    int width_mm, height_mm;
    int leaves;
};

static const struct vine vines[] = {
    {14700, 1250, 8300, -90, 1500, 1500, 20},
    {12700, 1450, 10000, 180, 2200, 900, 14},
    {11250, 2350, 8600, 90, 900, 1300, 8},
};

static void add_vine(struct soup *soup, const struct vine *vine)
{
    struct frame wall = frame_at(vine->x_mm, vine->y_mm, vine->z_mm, vine->yaw_deg);
    for (int i = 0; i < vine->leaves; i++) {
        double angle = 2 * DEMO_PI * soup_random(soup), radius = sqrt(soup_random(soup)) / 2;
        double x = radius * cos(angle) * vine->width_mm, y = radius * sin(angle) * vine->height_mm;
        double w = 55 + 45 * soup_random(soup), h = 1.5 * w;
        struct frame leaf = frame_tip(frame_move(wall, x, y, 20 + 2 * i), 90 * soup_random(soup) - 45);
        shape_quad(soup, &leaf, (const double[4][3]){{0, -h, 0}, {w, 0, 0}, {0, h, 0}, {-w, 0, 0}}, LEAF_DARK + i % 2);
    }
}

/* Books side by side along a shelf, with a gap here and there. Between gaps their spines are flush, so
 * that only the taller of two neighbours shows its side. */
static void add_books(struct soup *soup, const struct frame *shelf, int from_mm, int to_mm, int most_mm)
{
    int height = 0, next = most_mm - 90, depth = 0;
    for (int left = from_mm, right; (right = left + 110 + (int)(120 * soup_random(soup))) < to_mm; left = right) {
        int before = height, drawn = 60 + (int)(40 * soup_random(soup));
        int colour = BOOK_RED + (int)(6 * soup_random(soup));
        if (!before) depth = drawn;
        height = next;
        next = soup_random(soup) < 0.12 ? 0 : most_mm - 30 - (int)(150 * soup_random(soup));
        int hidden = LEG | NO_BACK | (before >= height ? NO_LEFT : 0) | (next >= height ? NO_RIGHT : 0);
        struct box book = {{left, 0, -130}, {right, height, depth}, colour, hidden & ~NO_TOP, 0};
        if (height) shape_box(soup, shelf, &book);
    }
}

static void add_bookcase(struct soup *soup, const struct standing *item)
{
    static const int shelf_mm[][2] = {{90, 440}, {560, 440}, {1030, 440}, {1515, 455}};
    struct frame frame = frame_at(item->x_mm, item->y_mm, item->z_mm, item->yaw_deg);
    thing_build(soup, &frame, BOOKCASE);
    for (size_t i = 0; i < COUNT(shelf_mm); i++) {
        struct frame shelf = frame_move(frame, 0, shelf_mm[i][0], 0);
        add_books(soup, &shelf, -710, 710, shelf_mm[i][1]);
    }
}

static const struct standing bookcases[] = {
    {BOOKCASE, 8290, 0, 1140, -90},
    {BOOKCASE, 8290, 0, 3960, -90},
};

/* The painter's easel: the stand leans back, the canvas on its ledge with it, a prop behind. */
static void add_easel(struct soup *soup)
{
    struct frame stand = frame_at(4200, 0, 3650, -125);
    struct frame leaning = frame_lean(stand, 11), canvas = frame_move(leaning, 0, 800, 5);
    struct frame prop = frame_lean(frame_move(stand, 0, 12, -640), -10);
    struct box leg = {{-28, 0, -18}, {28, 1640, 18}, OAK, 0, 0};
    thing_build(soup, &leaning, EASEL_STAND);
    picture_stretch(soup, &canvas, WINDMILL, 960, 760);
    shape_box(soup, &prop, &leg);
}

void rooms_furnish(struct soup *soup)
{
    for (size_t i = 0; i < COUNT(furniture); i++) {
        const struct standing *item = &furniture[i];
        struct frame frame = frame_at(item->x_mm, item->y_mm, item->z_mm, item->yaw_deg);
        thing_build(soup, &frame, item->thing);
    }
    for (size_t i = 0; i < COUNT(pictures); i++) {
        const struct hanging *item = &pictures[i];
        struct frame frame = frame_at(item->x_mm, item->y_mm, item->z_mm, item->yaw_deg);
        picture_hang(soup, &frame, item->picture, item->width_mm, item->height_mm);
    }
    for (size_t i = 0; i < COUNT(cloths); i++) {
        struct frame frame = frame_at(cloths[i].x_mm, cloths[i].y_mm, cloths[i].z_mm, cloths[i].yaw_deg);
        shape_drape(soup, &frame, &cloths[i].drape);
    }
    for (size_t i = 0; i < COUNT(vines); i++)
        add_vine(soup, &vines[i]);
    for (size_t i = 0; i < COUNT(bookcases); i++)
        add_bookcase(soup, &bookcases[i]);
    add_easel(soup);
}
