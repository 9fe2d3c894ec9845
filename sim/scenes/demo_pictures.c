/* SPDX-License-Identifier: MIT
 *
 * Pictures: strokes are convex outlines in thousandths of the canvas, later ones over earlier. */
#include "demo_pictures.h"
#include "demo_shape.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

enum { STROKE_CORNERS = 6 };

struct stroke {
    int material;
    int count;
    int at[STROKE_CORNERS][2]; /* x from the left, y from below */
};

struct picture {
    int ground, moulding; /* materials of the bare canvas and of the frame round it */
    int moulding_mm;
    int strokes;
    const struct stroke *stroke;
};

static const struct stroke seascape[] = {
    {PAINT_CLOUD, 5, {{80, 620}, {420, 600}, {560, 700}, {380, 850}, {150, 780}}},
    {PAINT_CLOUD, 4, {{620, 780}, {920, 740}, {960, 860}, {720, 900}}},
    {PAINT_SEA, 4, {{0, 0}, {1000, 0}, {1000, 400}, {0, 400}}},
    {PAINT_SEA_DARK, 4, {{0, 0}, {1000, 0}, {1000, 90}, {0, 190}}},
    {PAINT_DARK, 4, {{400, 230}, {690, 230}, {760, 340}, {350, 320}}},
    {PAINT_DARK, 4, {{545, 330}, {560, 330}, {560, 880}, {545, 880}}},
    {LINEN, 4, {{575, 380}, {740, 400}, {700, 640}, {575, 660}}},
    {LINEN, 3, {{530, 380}, {530, 820}, {390, 400}}},
    {RED_CLOTH, 3, {{560, 880}, {560, 830}, {660, 850}}},
    {PAINT_SAND, 3, {{0, 385}, {240, 385}, {0, 440}}},
};

static const struct stroke windmill[] = {
    {PAINT_SUN, 4, {{0, 300}, {1000, 300}, {1000, 520}, {0, 480}}},
    {PAINT_CLOUD, 5, {{60, 720}, {330, 680}, {470, 760}, {300, 880}, {120, 850}}},
    {PAINT_GREEN, 4, {{0, 0}, {1000, 0}, {1000, 330}, {0, 330}}},
    {LEAF_DARK, 4, {{0, 0}, {420, 0}, {240, 230}, {0, 280}}},
    {PAINT_SEA, 4, {{500, 0}, {760, 0}, {690, 300}, {655, 300}}},
    {BRICK, 4, {{290, 240}, {450, 240}, {425, 560}, {315, 560}}},
    {PAINT_DARK, 3, {{305, 550}, {435, 550}, {370, 660}}},
    {PAINT_DARK, 4, {{345, 240}, {395, 240}, {395, 340}, {345, 340}}},
    {LINEN, 4, {{355, 590}, {385, 580}, {650, 830}, {620, 870}}},
    {LINEN, 4, {{350, 570}, {375, 600}, {130, 860}, {95, 820}}},
    {LINEN, 4, {{575, 335}, {610, 370}, {385, 585}, {360, 560}}},
    {LINEN, 4, {{125, 380}, {160, 345}, {370, 560}, {345, 585}}},
    {LEAF, 4, {{780, 315}, {960, 315}, {920, 430}, {820, 420}}},
};

static const struct stroke portrait[] = {
    {OAK_DARK, 4, {{560, 0}, {1000, 0}, {1000, 1000}, {760, 1000}}},
    {EBONY, 6, {{120, 0}, {880, 0}, {840, 260}, {660, 390}, {340, 390}, {160, 260}}},
    {LINEN, 6, {{300, 330}, {500, 260}, {700, 330}, {660, 430}, {500, 460}, {340, 430}}},
    {SKIN, 6, {{400, 420}, {500, 370}, {600, 420}, {640, 640}, {500, 740}, {360, 640}}},
    {HAIR, 4, {{320, 470}, {380, 430}, {400, 640}, {355, 600}}},
    {HAIR, 4, {{620, 430}, {680, 470}, {645, 600}, {600, 640}}},
    {RED_CLOTH, 6, {{250, 640}, {750, 640}, {760, 710}, {600, 830}, {400, 830}, {250, 720}}},
    {HAIR, 4, {{430, 560}, {480, 560}, {480, 580}, {430, 580}}},
    {HAIR, 4, {{525, 560}, {575, 560}, {575, 580}, {525, 580}}},
};

static const struct stroke still_life[] = {
    {OAK_DARK, 4, {{0, 250}, {1000, 250}, {1000, 560}, {0, 380}}},
    {GREEN_CLOTH, 4, {{0, 0}, {1000, 0}, {1000, 280}, {0, 280}}},
    {LINEN, 4, {{560, 0}, {1000, 0}, {1000, 290}, {640, 290}}},
    {PEWTER, 6, {{150, 270}, {330, 270}, {370, 430}, {290, 560}, {190, 560}, {110, 430}}},
    {PEWTER, 4, {{200, 540}, {280, 540}, {290, 720}, {190, 720}}},
    {LEMON, 6, {{420, 240}, {530, 240}, {580, 310}, {530, 370}, {430, 370}, {380, 310}}},
    {APPLE, 6, {{680, 250}, {790, 250}, {840, 340}, {790, 430}, {680, 430}, {630, 340}}},
    {WINE, 5, {{560, 400}, {640, 440}, {660, 560}, {540, 560}, {520, 470}}},
    {BREAD, 5, {{800, 240}, {950, 240}, {970, 330}, {900, 380}, {820, 340}}},
};

static const struct stroke miniature_lady[] = {
    {ROSE, 4, {{100, 0}, {900, 0}, {700, 330}, {300, 330}}},
    {HAIR, 6, {{280, 350}, {720, 350}, {800, 650}, {650, 880}, {350, 880}, {200, 650}}},
    {SKIN, 6, {{420, 300}, {580, 300}, {680, 520}, {620, 740}, {380, 740}, {320, 520}}},
    {LINEN, 4, {{300, 270}, {700, 270}, {600, 350}, {400, 350}}},
};

static const struct stroke miniature_lord[] = {
    {EBONY, 4, {{60, 0}, {940, 0}, {750, 330}, {250, 330}}},
    {SKIN, 6, {{420, 300}, {580, 300}, {680, 500}, {640, 700}, {360, 700}, {320, 500}}},
    {LINEN, 4, {{240, 280}, {760, 280}, {640, 390}, {360, 390}}},
    {EBONY, 4, {{180, 680}, {820, 680}, {640, 900}, {360, 900}}},
};

static const struct stroke map[] = {
    {PAINT_SEA, 4, {{60, 80}, {940, 80}, {940, 920}, {60, 920}}},
    {PAINT_SAND, 6, {{330, 80}, {940, 80}, {940, 560}, {760, 640}, {520, 500}, {400, 300}}},
    {PAINT_GREEN, 5, {{560, 640}, {760, 640}, {900, 760}, {860, 920}, {600, 920}}},
    {PAINT_GREEN, 5, {{600, 130}, {860, 130}, {880, 380}, {720, 470}, {580, 330}}},
    {PAINT_SAND, 5, {{150, 560}, {260, 520}, {330, 660}, {300, 840}, {180, 780}}},
    {RED_CLOTH, 4, {{690, 260}, {750, 260}, {750, 320}, {690, 320}}},
    {PAPER, 4, {{90, 120}, {270, 120}, {270, 260}, {90, 260}}},
    {PAINT_SEA_DARK, 4, {{60, 900}, {940, 900}, {940, 920}, {60, 920}}},
};

static const struct picture pictures[PICTURES] = {
    [SEASCAPE] = {PAINT_SKY, EBONY, 70, COUNT(seascape), seascape},
    [WINDMILL] = {PAINT_SKY, GILT, 60, COUNT(windmill), windmill},
    [PORTRAIT] = {PAINT_DARK, GILT, 80, COUNT(portrait), portrait},
    [STILL_LIFE] = {PAINT_DARK, EBONY, 60, COUNT(still_life), still_life},
    [MINIATURE_LADY] = {BLUE_CLOTH, GILT, 30, COUNT(miniature_lady), miniature_lady},
    [MINIATURE_LORD] = {GREEN_CLOTH, GILT, 30, COUNT(miniature_lord), miniature_lord},
    [MAP] = {PAPER, EBONY, 35, COUNT(map), map},
};

/* Each stroke lies on the one before, this much higher: no two share a plane. So strokes that meet
 * overlap: what merely touched would show what lies below to whoever looks from the side. */
static const double coat_mm = 1.5;

static void paint(struct soup *soup, const struct frame *canvas, const struct picture *picture, int width_mm,
                  int height_mm)
{
    for (int i = 0; i < picture->strokes; i++) {
        const struct stroke *stroke = &picture->stroke[i];
        struct vec3 outline[STROKE_CORNERS];
        for (int j = 0; j < stroke->count; j++)
            outline[j] = frame_point(canvas, (stroke->at[j][0] - 500) * width_mm / 1000.0,
                                     stroke->at[j][1] * height_mm / 1000.0, (i + 1) * coat_mm);
        soup_add(soup, outline, stroke->count, stroke->material);
    }
}

void picture_stretch(struct soup *soup, const struct frame *frame, enum picture_id id, int width_mm, int height_mm)
{
    /* its sides reach up to the last stroke, so that none is seen to float */
    int ground_mm = 10, thick_mm = ground_mm + (int)ceil(pictures[id].strokes * coat_mm);
    struct box stretcher = {{-width_mm / 2, 0, 0}, {width_mm / 2, height_mm, thick_mm}, PAPER, NO_FRONT, 0};
    struct box ground = {
        {-width_mm / 2, 0, 0}, {width_mm / 2, height_mm, ground_mm}, pictures[id].ground, ~NO_FRONT, 0};
    struct frame canvas = frame_move(*frame, 0, 0, ground_mm);
    shape_box(soup, frame, &stretcher);
    shape_box(soup, frame, &ground);
    paint(soup, &canvas, &pictures[id], width_mm, height_mm);
}

void picture_hang(struct soup *soup, const struct frame *frame, enum picture_id id, int width_mm, int height_mm)
{
    const struct picture *picture = &pictures[id];
    int w = width_mm / 2, h = height_mm / 2, rim = picture->moulding_mm;
    struct box moulding = {{-w - rim, -h - rim, 0}, {w + rim, h + rim, 30}, picture->moulding, NO_BACK, 0};
    struct box ground = {{-w, -h, 0}, {w, h, 32}, picture->ground, ~NO_FRONT, 0};
    struct frame canvas = frame_move(*frame, 0, -h, 32);
    shape_box(soup, frame, &moulding);
    shape_box(soup, frame, &ground);
    paint(soup, &canvas, picture, 2 * w, 2 * h);
}
