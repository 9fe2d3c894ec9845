/* SPDX-License-Identifier: MIT
 *
 * Draws a walk by Doom's own renderer, for sim/tools/tables/doom.sh to count its instructions: doom_view WAD MAP
 * CAMERAS [PICTURES]. It is linked with the sources of chocolate-doom (sim/tools/doom.sh), whose game, sounds and
 * windows stay out. CAMERAS: a line a frame, as `limner walk` writes them; what looks up or down looks straight on
 * here. The map has no things in it, as no scene of ours has, and no weapon is held. PICTURES: a pattern for PPM files,
 * as out/%03d.ppm. The walk is drawn twice: the first time textures are composed and lumps are read; view() is the
 * second. */
#include <doomdef.h>
#include <doomstat.h>
#include <i_system.h>
#include <i_video.h>
#include <m_argv.h>
#include <p_local.h>
#include <p_setup.h>
#include <p_spec.h>
#include <r_local.h>
#include <r_sky.h>
#include <w_wad.h>
#include <z_zone.h>

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void R_ExecuteSetViewSize(void);

enum { UNITS_A_M = 32, ZONE_B = 64 << 20, WHOLE_SCREEN = 11 };

/* -- What the rest of Doom would be -------------------------------------------------------------------------------- */

pixel_t *I_VideoBuffer;
int gametic;

void I_Error(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    exit(1);
}

void *I_Realloc(void *memory, size_t size_b)
{
    return realloc(memory, size_b);
}

byte *I_ZoneBase(int *size_b)
{
    return malloc((size_t)(*size_b = ZONE_B));
}

boolean I_ConsoleStdout(void)
{
    return false;
}

void V_BeginRead(size_t size_b)
{
    (void)size_b;
}

int M_CheckParm(const char *name)
{
    (void)name;
    return 0;
}

boolean M_ParmExists(const char *name)
{
    (void)name;
    return false;
}

int M_CheckParmWithArgs(const char *name, int count)
{
    (void)name, (void)count;
    return 0;
}

void NetUpdate(void) {}
void S_Start(void) {}

void S_StartSound(void *origin, int sound)
{
    (void)origin, (void)sound;
}

/* -- The map ------------------------------------------------------------------------------------------------------- */

static void load_map(const char *wad, const char *map)
{
    const boolean has_episodes = toupper((unsigned char)map[0]) == 'E';

    Z_Init();
    if (!W_AddFile(wad)) I_Error("%s: cannot be read", wad);
    W_GenerateHashTable();
    gamemode = has_episodes ? retail : commercial;
    gamemission = has_episodes ? doom : doom2;
    nomonsters = true;
    precache = false;
    R_Init();
    P_InitSwitchList();
    P_InitPicAnims();
    skyflatnum = R_FlatNumForName(SKYFLATNAME);
    skytexture = R_TextureNumForName("SKY1");
    P_SetupLevel(has_episodes ? map[1] - '0' : 1, atoi(map + 3), 0, sk_medium);
    for (int i = 0; i < numsectors; i++)
        sectors[i].thinglist = NULL;
    R_SetViewSize(WHOLE_SCREEN, 0);
    R_ExecuteSetViewSize();
}

/* -- The walk ------------------------------------------------------------------------------------------------------ */

static fixed_t fixed_of(double value_m)
{
    return (fixed_t)lrint(value_m * UNITS_A_M * FRACUNIT);
}

static boolean read_camera(FILE *file, player_t *player)
{
    char line[256];
    double eye_m[3], target_m[3];

    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "%lf %lf %lf %lf %lf %lf", eye_m, eye_m + 1, eye_m + 2, target_m, target_m + 1,
                   target_m + 2) != 6)
            continue;
        const double turns = atan2(eye_m[2] - target_m[2], target_m[0] - eye_m[0]) / (2 * acos(-1));
        player->mo->x = fixed_of(eye_m[0]);
        player->mo->y = fixed_of(-eye_m[2]);
        player->mo->angle = (angle_t)(int64_t)(turns * 4294967296.0);
        player->mo->subsector = R_PointInSubsector(player->mo->x, player->mo->y);
        player->viewz = fixed_of(eye_m[1]);
        return true;
    }
    return false;
}

static void write_picture(const char *pattern, int frame)
{
    const byte *palette = W_CacheLumpName("PLAYPAL", PU_STATIC);
    char name[512];

    snprintf(name, sizeof name, pattern, frame);
    FILE *const file = fopen(name, "wb");
    if (!file) I_Error("%s: cannot be written", name);
    fprintf(file, "P6 %d %d 255\n", SCREENWIDTH, SCREENHEIGHT);
    for (int i = 0; i < SCREENWIDTH * SCREENHEIGHT; i++)
        fwrite(palette + 3 * I_VideoBuffer[i], 3, 1, file);
    fclose(file);
}

void warm(player_t *player);
void view(player_t *player);

__attribute__((noinline)) void warm(player_t *player)
{
    R_RenderPlayerView(player);
    __asm__ volatile("");
}

__attribute__((noinline)) void view(player_t *player)
{
    R_RenderPlayerView(player);
    __asm__ volatile("" ::: "memory");
}

static int walk(const char *cameras, player_t *player, void draw(player_t *), const char *pictures)
{
    FILE *const file = fopen(cameras, "r");
    int frames = 0;

    if (!file) I_Error("%s: cannot be read", cameras);
    for (; read_camera(file, player); frames++) {
        draw(player);
        if (pictures) write_picture(pictures, frames);
    }
    fclose(file);
    return frames;
}

int main(int argc, char **argv)
{
    static pixel_t screen[SCREENWIDTH * SCREENHEIGHT];
    static mobj_t body;

    if (argc < 4) I_Error("usage: doom_view WAD MAP CAMERAS [PICTURES]");
    I_VideoBuffer = screen;
    load_map(argv[1], argv[2]);
    players[0].mo = &body;
    walk(argv[3], &players[0], warm, NULL);
    printf("\n%d frames\n", walk(argv[3], &players[0], view, argc > 4 ? argv[4] : NULL));
    return 0;
}
