/* SPDX-License-Identifier: MIT
 *
 * The host program `limner`: hands its arguments to a subcommand. */
#include "base/arguments.h"
#include "base/deadline.h"
#include "base/ending.h"
#include "base/streams.h"
#include "cli/commands.h"
#include "cli/fly.h"
#include "readers/companion.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char USAGE[] =
    "usage: limner compile MODEL -o NAME   write NAME.c, NAME.h and NAME.lim, and report\n"
    "       limner compile MODEL... -o NAME  several scenes for one firmware: they share NAME.h\n"
    "       limner render MODEL|SCENE.lim  draw frames into files\n"
    "       limner view MODEL|SCENE.lim    fly through a scene\n"
    "       limner measure MODEL           what each precision gets wrong and costs\n"
    "       limner compare MODEL           what each visibility method gets wrong and costs\n"
    "       limner play MODEL|SCENE.lim    fly a camera path on a real display, by SPI and GPIO\n"
    "       limner devices                 what a display can hang on here, and why not\n"
    "       limner module -o NAME          a display's module as NAME.c and NAME.h, for firmware\n"
    "       limner card                    the test card as a display's module shows it, for comparison\n"
    "       limner decode FILE|-           frames out of what went over a display's wires, or an analyser captured\n"
    "       limner hashes PICTURE.png...   of pictures that others' displays showed\n"
    "       limner bridge                  frames a second over USB-HID, predicted; or of one --panel NAME --size WxH\n"
    "       limner splitters MODEL         what each heuristic makes of the tree\n"
    "       limner uf2 IMAGE.bin -o IMAGE.uf2  what is copied to an RP2040's boot drive (--family rp2040)\n"
    "       limner boot2 CODE.bin -o NAME.c  an RP2040's second stage, with its checksum\n"
    "       limner report-bug MODEL|SCENE.lim  what was drawn, and all that it takes to draw it again, in one file\n"
    "       limner replay REPORT.tar       draws it again; exit status 1 if a frame differs\n"
    "       limner help                    this text\n"
    "\n"
    "compile, render, view and measure, for a MODEL; compare and splitters take some of these, below:\n"
    "  --precision NAME    draft, fast, fine or exact (fast)\n"
    "  --method NAME       nearest, painter, convex for one convex solid, scanline for flat scenes of which\n"
    "                      little is hidden (compile, measure: chosen if cheaper); nearest first with a tree of\n"
    "                      that kind: bsp, clusters, axis, octree (nearest or convex);\n"
    "                      without a tree: depth, by farthest points, and newell, which puts that right\n"
    "                      portals: the same with --portals on\n"
    "  --tree NAME         auto, bsp, clusters, axis, octree or none: a set; auto: bsp, clusters or axis, whichever "
    "draws\n"
    "                      sampled cameras cheapest (auto where bsp splits a quarter, else bsp)\n"
    "  --splitter NAME     which polygon's plane divides: first, fewest, balanced, weighted, sampled,\n"
    "                      or the best of fewest and all weights: auto (auto)\n"
    "  --tolerance UNITS   how far a polygon may be off a plane that it lies on (0.5)\n"
    "  --size WxH          of the panel, 1 to 1024 pixels each (240x240)\n"
    "  --near M            distance of the near plane, metres (0.1; more in scenes of more than 2 km)\n"
    "  --drop-small        leave out what is too small for the scene's grid, instead of refusing the model\n"
    "  --unlit             colours as they are in the model: no light is baked in\n"
    "  --wireframe         for drawing outlines alone, hidden lines left out (render, view: drawn so;\n"
    "                      --wireframe=RRGGBB,RRGGBB: all lines and the background in these colours)\n"
    "  --antialias         for smooth edges, methods that draw nearest first (render, view: drawn so)\n"
    "  --delta             for sending what changes alone (render, view: sent so; --delta=RUNS: with memory for\n"
    "                      so many runs of one colour)\n"
    "  --trust-paths       files that a MODEL names (materials, textures, buffers) may lie outside of its folder:\n"
    "                      paths with `..`, absolute ones, links (all commands that read a MODEL)\n"
    "compile and measure, for a MODEL:\n"
    "  --framebuffer       for boards with RAM for all pixels, 16 bits each: fewer instructions; for\n"
    "                      opaque scenes in whole colours, in which nothing moves\n"
    "  --portals WHEN      store what can be seen from where: on, off, or auto, where it pays (measure: off)\n"
    "compile and render, of models with animations (measure and compare draw all of the animation):\n"
    "  --movers NAME       how what moves enters the scene: clipped down its tree, centre (faster, and wrong\n"
    "                      where it reaches through planes), off: it stays where the file has it (clipped)\n"
    "  --mover-light NAME  baked into its colours where the file has it, or turning: lit in each frame (baked)\n"
    "compile only:\n"
    "  --keep-faces        do not merge coplanar neighbours of one colour\n"
    "  --round             for round glass: what it does not show is left out\n"
    "  --frame             for boards that keep the whole picture in pixels of their own, as greys: fewer "
    "instructions\n"
    "  --report            without -o: only report\n"
    "  --max-error P%      the cheapest precision with at most P % wrong pixels\n"
    "  --max-vertex-error Ppx  the same for the largest error of a vertex\n"
    "  --camera FILE       or random:SEED[:FRAMES]: where that must hold (cameras sampled in the scene's free space)\n"
    "  --core NAME         whose instructions count: m0plus, m3, m4, rv32 (fewest bits)\n"
    "render and view:\n"
    "  --camera FILE       a line a frame: ex ey ez tx ty tz, metres (an orbit of 16 frames); or\n"
    "                      random:SEED[:FRAMES], at random in the scene's free space (64 frames); or near:...,\n"
    "                      the same near the model's faces, small ones as often as large ones\n"
    "  --fov DEG           vertical field of view (60)\n"
    "  --panel NAME        of an emulated chip: gc9a01, ili9341, ili9488, ssd1351, st7735, st7789, perhaps with\n"
    "                      :rgb444 or :rgb666; 16 greys: ssd0323, ssd1327; black and white: pcd8544, sh1106,\n"
    "                      ssd1306, st7567, uc1701; memory LCDs: ls013b7dh03, ls027b7dh01;\n"
    "                      or memory (st7789 where the size fits into it); or framebuffer, memory that the\n"
    "                      renderer paints into polygon by polygon\n"
    "render only:\n"
    "  -o PATTERN          a PNG file a frame ('out/%03d.png' if nothing else is asked for)\n"
    "  --gif FILE          all frames, animated\n"
    "  --sheet FILE        up to 24 frames in one PNG file\n"
    "  --ids FILE          face numbers: uint32 little-endian a pixel, 0 = background; merges no faces\n"
    "  --fps N             frames a second of what moves (15)\n"
    "  --stats             what each frame cost\n"
    "  --newell LIST       planes: compare with planes before rectangles; one: split one of two;\n"
    "                      most=N: at most so many comparisons a frame (256 times the square of the polygons)\n"
    "  --compare           how each frame differs from the double-precision reference\n"
    "  --write-hashes FILE a hash a frame\n"
    "  --write-cameras FILE  the cameras as a C header, for firmware of this scene\n"
    "  --check FILE        compare with such a file; exit status 1 if a frame differs\n"
    "measure:\n"
    "  --camera, --size, --fov, --near, --unlit, --keep-faces, --method, --tree, --splitter, --delta as above\n"
    "  -o DIR              measure.md, measure.csv, stages.csv and measure.png\n"
    "  --precision LIST    names, divided by commas (all, with other sub-pixel bits too)\n"
    "  --core LIST         processors: m0plus, m3, m4, rv32 (all)\n"
    "  --no-cost           accuracy only: takes neither compilers nor emulators\n"
    "compare:\n"
    "  --camera, --size, --fov, --near, --unlit, --keep-faces, --no-cost as above\n"
    "  -o DIR              compare.md, compare.csv, and in red what is wrong: sheet.png, METHOD.png\n"
    "  --precision NAME    (fast)\n"
    "  --core LIST         processors (m0plus,m4); without their tools: dashes\n"
    "  --frames N          of the cameras, evenly chosen (all)\n"
    "  --cost-frames N     of these, for instructions (4)\n"
    "splitters: --tree, --tolerance, --size, --near, --unlit, --keep-faces as above\n"
    "play: what view takes, but for a MODEL's own panel; loops until it is ended, unless there is --frames\n"
    "  --panel NAME        the display's controller, as above, perhaps with a format\n"
    "  --spi DEVICE        as /dev/spidev0.0\n"
    "  --hid [SERIAL]      instead: a USB-HID bridge, MCP2210 (the only one; =SERIAL if it is no number);\n"
    "                      its lines are GP0 to GP8, --cs LINE is chip select (tied low)\n"
    "  --dc, --reset, --backlight, --te, --select LINE  GPIO lines by name or CHIP:NUMBER (not wired)\n"
    "  --hz N, --mode 0-3  of the bus (as is usual with that controller); --no-cs, --cs-high: what it selects with\n"
    "  --size WxH          of the glass, upright; --offset X,Y: of its corner in the chip's memory\n"
    "  --memory WxH        what the module's mode pins leave of the chip's memory (as is usual for that size)\n"
    "  --start-line N      memory's line that the glass begins with, where the chip is told one (0)\n"
    "  --rotate DEG        the picture, clockwise; --mirror: its left and right exchanged\n"
    "  --mirror-columns, --mirror-rows  of the glass, however the picture is turned\n"
    "  --bgr, --rgb, --invert, --no-invert  if colours are wrong (as is usual with that controller)\n"
    "  --contrast N        1 to what the chip takes (as is usual with that controller)\n"
    "  --wiring sequential|alternative  of the lines of mono OLEDs (as is usual for that size)\n"
    "  --converter         the controller's own one makes the glass's voltage (from outside): ssd0323\n"
    "  --frames N          ends after so many\n"
    "  --test-card         instead of a scene: corners clockwise red, green, blue and a grey ramp\n"
    "module: --panel, --hz, --mode and what follows --size, but for --frames and --test-card, as play\n"
    "card: --panel and the module's options as above; -o FILE.png, --write-hashes FILE, --check FILE\n"
    "decode: --panel and the module's options as above; FILE is a wire log: lines `b XX ...` for bytes, `p NAME 0|1`\n"
    "        for levels of dc, reset, select, backlight, cs and led, which ends frames, `t NANOSECONDS`, `# ...`\n"
    "  --qemu MAP          instead: what QEMU prints with -trace memory_region_ops_write; MAP says which registers\n"
    "                      are which wires: `spi ADDRESS`, `pin NAME bsrr|clear|masked|output ADDRESS BIT`\n"
    "  --foreign           the log is of somebody else's driver: what glass would bear is told, and no error\n"
    "  or a logic analyser's capture: a VCD, or sigrok's session (.sr)\n"
    "  --wires dc=D0,...   which channels are dc, sck, mosi, cs, reset, select, backlight and led (those with usual\n"
    "                      names: DC RS A0, SCK SCLK CLK, MOSI SDA DIN, CS CE SS, RST RES, BL, LED); cs=-: none\n"
    "  --running           the firmware was started before the capture: the display is taken for one that is set up\n"
    "  --pause US          a frame ends where nothing comes for so long (without led: where the picture is whole)\n"
    "  --frames N          ends after so many (all)\n"
    "  -o PATTERN, --write-hashes FILE, --check FILE  as render\n"
    "  --check-loop FILE   of frames that are shown for ever, seen from any of them on\n"
    "hashes: --write-hashes FILE, --check FILE as render; --shrink N: a pixel is NxN of the picture's (1)\n"
    "report-bug: what render takes; pictures are left out\n"
    "  -o FILE             the report (limner-report.tar): a tar archive of the model, the files that it names,\n"
    "                      cameras, options, versions and a hash a frame\n"
    "replay:\n"
    "  -o FILE             the report anew, with what comes out now\n"
    "all that take a MODEL:\n"
    "  --time-limit SECONDS  then the best so far counts, said as such; nothing yet is an error (600, or\n"
    "                      LIMNER_TIME_LIMIT in the environment; 0: none). play and view: until they fly\n"
    "environment, render and view:\n"
    "  LIMNER_DUMP=x.png   write the last frame shown\n"
    "  LIMNER_CHECK=x.png  compare it; exit status 1 if it differs\n"
    "  LIMNER_UNSEEN=1     view: SDL's video drivers dummy and offscreen, which show nothing, do for a window\n"
    "                      (the terminal takes over)\n";

static const struct command {
    const char *name;
    int (*run)(int argc, char **argv);
    bool is_long; /* reads models, takes --time-limit */
} COMMANDS[] = {{"compile", cmd_compile, true}, {"render", cmd_render, true},
                {"view", cmd_view, true},       {"measure", cmd_measure, true},
                {"compare", cmd_compare, true}, {"splitters", cmd_splitters, true},
                {"play", cmd_play, true},       {"devices", cmd_devices, false},
                {"bridge", cmd_bridge, false},  {"module", cmd_module, false},
                {"card", cmd_card, false},      {"decode", cmd_decode, false},
                {"hashes", cmd_hashes, false},  {"uf2", cmd_uf2, false},
                {"boot2", cmd_boot2, false},    {"report-bug", cmd_report_bug, true},
                {"replay", cmd_replay, true}};

/* --trust-paths, which means the same to all commands that read models, is taken out. */
static int take_trust(int argc, char **argv)
{
    int kept = 0;
    bool is_option = true;
    for (int i = 0; i < argc; i++) {
        is_option = is_option && strcmp(argv[i], "--") != 0;
        if (is_option && strcmp(argv[i], "--trust-paths") == 0)
            companions_trust();
        else
            argv[kept++] = argv[i];
    }
    argv[kept] = NULL;
    return kept;
}

static bool asks_for_help(const char *argument)
{
    return strcmp(argument, "help") == 0 || strcmp(argument, "--help") == 0 || strcmp(argument, "-h") == 0;
}

/* The time runs from here. */
static bool begin_time(const struct command *command, struct arguments *arguments, struct error *err)
{
    const char *text = NULL;
    double limit_s;
    if (!command->is_long) return true;
    if (!arguments_value(arguments, "--time-limit", &text, err) || !deadline_parse(text, &limit_s, err)) return false;
    deadline_begin(limit_s);
    return true;
}

static int run_command(const struct command *command, int argc, char **argv)
{
    struct arguments arguments = {argv, command->is_long ? take_trust(argc, argv) : argc};
    struct error err;
    if (begin_time(command, &arguments, &err)) return command->run(arguments.count, arguments.items);
    fprintf(stderr, "limner: %s\n", err.text);
    return EXIT_FAILURE;
}

static int run(int argc, char **argv)
{
    if (argc < 2) {
        fputs("limner: no command; `limner help` lists them\n", stderr);
        return EXIT_FAILURE;
    }
    if (asks_for_help(argv[1]) || (argc == 3 && asks_for_help(argv[2]))) {
        printf("%s\nkeys of view: %s\n", USAGE, FLY_HELP);
        return EXIT_SUCCESS;
    }
    for (size_t i = 0; i < sizeof COMMANDS / sizeof COMMANDS[0]; i++)
        if (strcmp(argv[1], COMMANDS[i].name) == 0) return run_command(&COMMANDS[i], argc - 1, argv + 1);
    fprintf(stderr, "limner: no command '%s'; `limner help` lists them\n", argv[1]);
    return EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    streams_prepare();
    ending_prepare();
    const int status = run(argc, argv);
    if (status == 0) deadline_tell();
    return streams_end(status);
}
