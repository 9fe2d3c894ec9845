/* SPDX-License-Identifier: MIT
 *
 * What `limner help` and `limner COMMAND --help` print. Both are made of one table: an entry is an option with the
 * commands that take it, or a heading, which `limner help` alone prints. */
#include "cli/usage.h"

#include "cli/fly.h"

#include <string.h>

/* Bits of entries, in the order of COMMANDS below. */
enum {
    COMPILE = 1 << 0,
    RENDER = 1 << 1,
    VIEW = 1 << 2,
    MEASURE = 1 << 3,
    COMPARE = 1 << 4,
    SPLITTERS = 1 << 5,
    PLAY = 1 << 6,
    DEVICES = 1 << 7,
    BRIDGE = 1 << 8,
    MODULE = 1 << 9,
    CARD = 1 << 10,
    DECODE = 1 << 11,
    HASHES = 1 << 12,
    UF2 = 1 << 13,
    BOOT2 = 1 << 14,
    REPORT_BUG = 1 << 15,
    REPLAY = 1 << 16,
    ESPIMAGE = 1 << 17,
    EXPORT = 1 << 18,
    WORST = 1 << 19,
    PAGE = 1 << 20,
    WALK = 1 << 22, /* 21: wad, which takes none */
    SWEEP = 1 << 23,
    FORMATS = 1 << 24,
    ONE = WORST | PAGE,
    SCENES = COMPILE | RENDER | VIEW | PLAY | REPORT_BUG | EXPORT,
    MODELS = SCENES | MEASURE | COMPARE | SPLITTERS | ONE,
    MODULES = PLAY | MODULE | CARD | DECODE | EXPORT,
    FIRST = 1 << 29, /* what most people want to know: a command's help begins with it, and without `all` ends there */
    ALONE = 1 << 30  /* in a command's own help alone: the whole has said it in a heading */
};

static const struct usage_command COMMANDS[] = {
    {"compile", "MODEL... -o NAME",
     "Compiles a model for firmware: NAME.c, NAME.h and NAME.lim, and a summary. Several models share NAME.h.",
     "limner compile house.obj --size 240x240 --precision fine -o house"},
    {"render", "MODEL|SCENE.lim", "Draws frames into files.",
     "limner render house.obj --camera walk.cam --gif walk.gif --stats"},
    {"view", "MODEL|SCENE.lim", "Flies through a scene in a window.",
     "limner view house.obj --panel st7735 --size 128x160"},
    {"measure", "MODEL", "Says what each precision gets wrong and costs.",
     "limner measure house.obj --camera random:1 -o out"},
    {"compare", "MODEL", "Says what each visibility method gets wrong and costs.",
     "limner compare house.obj --camera walk.cam --frames 8 -o out"},
    {"splitters", "MODEL", "Says what each heuristic makes of the tree.", "limner splitters house.obj"},
    {"play", "MODEL|SCENE.lim",
     "Flies a camera path on a real display, by SPI and GPIO or a USB bridge; loops until it is ended.",
     "limner play house.obj --panel st7789 --spi /dev/spidev0.0 --dc GPIO25 --reset GPIO24"},
    {"devices", "", "Lists what a display can hang on here, and why not.", "limner devices"},
    {"bridge", "[MODEL CAMERAS.cam]", "Predicts frames a second over USB-HID.",
     "limner bridge --panel ssd1306 --size 128x64"},
    {"module", "--panel NAME -o NAME", "Writes a display's module as NAME.c and NAME.h, for firmware.",
     "limner module --panel st7735 --size 128x160 -o display"},
    {"card", "--panel NAME", "Draws the test card as a display's module shows it, for comparison.",
     "limner card --panel st7789 --size 240x240 -o card.png"},
    {"decode", "--panel NAME FILE|-",
     "Makes frames of what went over a display's wires, or of what an analyser captured.",
     "limner decode capture.vcd --panel st7789 -o 'out/%03d.png'"},
    {"hashes", "PICTURE.png...", "Hashes pictures that others' displays showed.",
     "limner hashes frame.png --check frame.hashes"},
    {"uf2", "IMAGE.bin -o IMAGE.uf2", "Makes what is copied to the boot drive of an RP2040 or RP2350.",
     "limner uf2 image.bin -o image.uf2"},
    {"boot2", "CODE.bin -o NAME.c", "Makes an RP2040's second stage, with its checksum.",
     "limner boot2 boot2.bin -o boot2.c"},
    {"report-bug", "MODEL|SCENE.lim",
     "Packs what was drawn, and all that it takes to draw it again, into one file. It takes what render takes.",
     "limner report-bug house.obj --camera walk.cam -o limner-report.tar"},
    {"replay", "REPORT.tar", "Draws a report again; exit status 1 if a frame differs.",
     "limner replay limner-report.tar"},
    {"espimage", "IMAGE.elf -o IMAGE.esp", "Makes what the ROM of an ESP32-C3 loads from flash.",
     "limner espimage image.elf -o image.esp"},
    {"export", "MODEL... --for WORLD -o FOLDER",
     "Writes a folder for a toolchain: renderer, scene, display, example. Without --panel and --size: its commonest "
     "display.",
     "limner export house.obj --for pico --panel ili9341 -o house"},
    {"worst", "MODEL", "Searches the camera that costs most and the one that errs most.",
     "limner worst house.obj --seconds 60 -o out/worst"},
    {"report", "MODEL -o FILE.html",
     "Writes a page: views, wrong pixels, what each stage costs, memory, the tree, the worst frames, what to do next.",
     "limner report house.obj -o house.html"},
    {"wad", "FILE.wad", "Lists a WAD's maps, each of which is a MODEL: FILE.wad:MAP, or IWAD.wad+PWAD.wad:MAP.",
     "limner wad freedoom1.wad"},
    {"walk", "MODEL|SCENE.lim -o FILE.cam",
     "Walks through a scene by itself, stopped by walls, up and down steps, to see all of it: cameras for render.",
     "limner walk freedoom1.wad:E1M1 --frames 256 -o walk.cam"},
    {"sweep", "MODEL... -o DIR",
     "Plans a `limner measure` for each model and setting, as commands for sh, GNU parallel or Slurm; joins their "
     "results.",
     "limner sweep a.obj b.obj --precision fast,exact --method auto,nearest -o out/sweep"},
    {"formats", "", "Lists what is read of each format of models, and what becomes of the rest.", "limner formats"},
};

static const struct usage_entry ENTRIES[] = {
    {0, "compile, render, view and measure, for a MODEL, which all draw as compile decides with the same options;\n"
        "compare and splitters take some of these, below:\n"},
    {SCENES | ONE | FIRST, "  --precision NAME    draft, fast, fine or exact (fast)\n"},
    {SCENES | MEASURE | ONE,
     "  --method NAME       nearest, painter, convex for one convex solid, scanline for flat scenes of which\n"
     "                      little is hidden (chosen if cheaper); nearest first with a tree of\n"
     "                      that kind: bsp, clusters, axis, octree (nearest or convex);\n"
     "                      without a tree: depth, by farthest points, and newell, which puts that right;\n"
     "                      mesh, triangles by distance, and mesh-depth, with a line of depths: approximate\n"
     "                      portals: the same with --portals on\n"},
    {SCENES | MEASURE | SPLITTERS | ONE,
     "  --tree NAME         auto, bsp, clusters, axis, octree, none: a set, or mesh; auto: bsp, clusters\n"
     "                      or axis, whichever draws sampled cameras cheapest (auto where bsp splits a quarter,\n"
     "                      else bsp)\n"},
    {SCENES | MEASURE | ONE,
     "  --mesh-leaves WHICH dense parts of a tree that no plane divides, ordered by distance: approximate; all of\n"
     "                      those that may be, none, or auto: where method and tree are open, those that cost less\n"
     "                      and err no more than the precision promises (auto)\n"},
    {SCENES | MEASURE | COMPARE | SPLITTERS | ONE,
     "  --coordinates BITS  16; 32 for scenes of many scales, in which the smallest face is 2^16 times smaller than\n"
     "                      all of it, or less; or auto: 32 where 16 would lose faces, or with --max-error err more\n"
     "                      (auto)\n"},
    {SCENES | MEASURE | COMPARE | ONE,
     "  --splitter NAME     which polygon's plane divides: first, fewest, balanced, weighted, sampled,\n"
     "                      or the best of fewest and all weights: auto (auto)\n"},
    {SCENES | SPLITTERS,
     "  --tolerance UNITS   how far a polygon may be off a plane that it lies on (0.5; in 1/256 of\n"
     "                      them where units are too large for the smallest faces)\n"},
    {COMPILE | RENDER | VIEW | REPORT_BUG | MEASURE | COMPARE | SPLITTERS | ONE | FIRST,
     "  --size WxH          of the panel, 1 to 1024 pixels each (240x240; compile, render, view: that of --panel)\n"},
    {MODELS, "  --near M            distance of the near plane, metres (0.1; more in scenes of more than 2 km;\n"
             "                      less with coordinates of 32 bits: 16 units)\n"},
    {MODELS | WALK,
     "  --drop-small        leave out what is too small for the scene's grid, instead of refusing the model\n"},
    {MODELS | WALK | FIRST,
     "  --up y|z            which axis of the file is up (y; of STL files what the model stands on, else z)\n"
     "  --reverse-faces     the file's faces run clockwise, seen from outside\n"
     "  --two-sided         all faces are seen from both sides, as those of open models may have to be\n"},
    {MODELS, "  --unlit             colours as they are in the model: no light is baked in\n"},
    {SCENES, "  --background RRGGBB  where no face is seen (000000)\n"},
    {SCENES,
     "  --wireframe         for drawing outlines alone, hidden lines left out (render, view: drawn so;\n"
     "                      --wireframe=RRGGBB,RRGGBB: all lines and the background in these colours; on black\n"
     "                      and white panels white on black, on memory LCDs black on white)\n"},
    {SCENES | MEASURE | COMPARE | ONE,
     "  --antialias         for smooth edges, methods that draw nearest first (render, view: drawn so)\n"},
    {SCENES | MEASURE | COMPARE,
     "  --delta             for sending what changes alone (render, view: sent so; --delta=RUNS: with memory for\n"
     "                      so many runs of one colour)\n"},
    {MODELS | REPLAY | WALK,
     "  --trust-paths       files that a MODEL names (materials, textures, buffers) may lie outside of its folder:\n"
     "                      paths with `..`, absolute ones, links (all commands that read a MODEL)\n"},
    {MODELS | REPLAY | WALK,
     "  --no-textures       as --textures flat, and a texture that cannot be read, otherwise an error, leaves faces\n"
     "                      their materials' colours (all commands that read a MODEL)\n"},
    {MODELS | REPLAY | WALK,
     "  --textures HOW      drawn (default), or flat: each face has one colour, the mean of what it would show of\n"
     "                      its texture; no flash is needed for them (all commands that read a MODEL)\n"},
    {MODELS | REPLAY | WALK,
     "  --doors NAME        of maps of WADs: closed, as they are (default), open, with lifts down, or move: objects\n"
     "                      that open or go down, wait and come back (all commands that read a MODEL)\n"},
    {MODELS | REPLAY | WALK,
     "  --sky MATERIAL      faces of that material are a sky: its picture is seen around the eye, endlessly far\n"
     "                      away, 1024 columns of it all round and the horizon at 25/32 of its height, as in Doom\n"
     "                      (all commands that read a MODEL; maps have theirs)\n"},
    {MODELS | REPLAY | WALK,
     "  --texture-budget KB  textures take so many KB at most, of 1000 bytes, palettes included: some get smaller, "
     "some\n"
     "                      show another or one colour, whichever loses least (all commands that read a MODEL)\n"},
    {0, "compile and measure, for a MODEL:\n"},
    {COMPILE | EXPORT | MEASURE | COMPARE | ONE,
     "  --framebuffer       for boards with RAM for all pixels, 16 bits each: fewer instructions; for\n"
     "                      opaque scenes in whole colours, in which nothing moves\n"},
    {COMPILE | EXPORT | MEASURE | COMPARE | ONE,
     "  --overlay           for text and figures over the frames (firmware/overlay.h; measure: the frame's number)\n"},
    {SCENES | MEASURE | ONE,
     "  --portals WHEN      store what can be seen from where: on, off, or auto, where it pays (auto)\n"},
    {(SCENES & ~REPORT_BUG) | MEASURE | COMPARE | ONE,
     "  --path FILE         the cameras that the program has, a line a frame as for --camera: method, tree and pools\n"
     "                      are for these views, and any other may cost a second walk (sampled cameras)\n"},
    {COMPILE | EXPORT | MEASURE | COMPARE | ONE,
     "  --worst             pools for the views that take most of 2000 searched ones (--worst=CAMERAS: of so many),\n"
     "                      beside those that are sampled: such frames take no second walk\n"},
    {0, "compile and render, of models with animations (measure and compare draw all of the animation):\n"},
    {COMPILE | EXPORT | RENDER | REPORT_BUG,
     "  --movers WHEN       on, or off: what is animated stays where the file has it (on)\n"},
    {COMPILE | EXPORT | RENDER | REPORT_BUG,
     "  --mover-light NAME  baked into its colours where the file has it, or turning: lit in each frame (baked)\n"},
    {0, "compile only:\n"},
    {COMPILE | ALONE | FIRST, "  -o NAME             NAME.c, NAME.h and NAME.lim\n"},
    {COMPILE | EXPORT | MEASURE | COMPARE | SPLITTERS | ONE,
     "  --keep-faces        do not merge coplanar neighbours of one colour\n"},
    {COMPILE | FIRST,
     "  --panel NAME        a chip, as render's --panel: its size, and if it is black and white light and tones\n"
     "                      that can be told apart there\n"},
    {COMPILE | EXPORT, "  --round             for round glass: what it does not show is left out\n"},
    {COMPILE | EXPORT,
     "  --fill              for boards that keep the whole picture in pixels of their own, as greys: fewer "
     "instructions\n"},
    {COMPILE | EXPORT | FIRST,
     "  --report            all that there is to say of the scene, not ten lines; compile without -o writes nothing\n"},
    {COMPILE | EXPORT | FIRST, "  --max-error P%      the cheapest precision with at most P % wrong pixels\n"},
    {COMPILE | EXPORT, "  --max-vertex-error Ppx  the same for the largest error of a vertex\n"},
    {COMPILE | EXPORT | FIRST,
     "  --fov DEG           the narrowest vertical field of view that the program has: with less than 14 degrees,\n"
     "                      whichever way, firmware is as exact through such lenses (60)\n"},
    {COMPILE | EXPORT | FIRST,
     "  --camera FILE       or random:SEED[:FRAMES]: where that must hold (cameras sampled in the scene's "
     "free space)\n"},
    {COMPILE | EXPORT, "  --core NAME         whose instructions count: m0plus, m3, m4, m33, rv32 (fewest bits)\n"},
    {0, "render and view:\n"},
    {RENDER | VIEW | PLAY | REPORT_BUG | MEASURE | COMPARE | PAGE | FIRST,
     "  --camera FILE       a line a frame: ex ey ez tx ty tz, metres (an orbit of 16 frames); or\n"
     "                      random:SEED[:FRAMES], at random in the scene's free space (64 frames); or near:...,\n"
     "                      the same near the model's faces, small ones as often as large ones; or grazing:...,\n"
     "                      the same along large faces, such as floors and corridors; or FILE.wad:MAP,\n"
     "                      where a map's players and things stand (16 of them, of such a MODEL); or a .gltf or .glb\n"
     "                      file: its cameras\n"},
    {RENDER | VIEW | PLAY | REPORT_BUG | MEASURE | COMPARE | ONE | FIRST,
     "  --fov DEG           vertical field of view (60; very wide pictures: what is 60 across)\n"},
    {RENDER | VIEW | REPORT_BUG | FIRST,
     "  --panel NAME        of an emulated chip: gc9a01, ili9341, ili9488, ssd1351, st7735, st7789, st7796,\n"
     "                      perhaps with :rgb444 or :rgb666; 16 greys: ssd0323, ssd1327; black and white:\n"
     "                      pcd8544, sh1106, ssd1306, st7567, uc1701; memory LCDs: ls013b7dh03, ls027b7dh01;\n"
     "                      or memory (st7789 where the size fits into it); or framebuffer, memory that the\n"
     "                      renderer paints into polygon by polygon\n"},
    {RENDER | VIEW | REPORT_BUG | FIRST,
     "  --rotate DEG        the picture, clockwise, on glass of --size: 90 and 270 exchange its sides (0)\n"},
    {0, "render only:\n"},
    {RENDER | FIRST,
     "  -o PATTERN          a PNG file a frame ('out/%03d.png' if nothing else is asked for), or house.png: "
     "one frame;\n"
     "                      house.gif: as --gif\n"},
    {RENDER | REPORT_BUG,
     "  --ram BYTES         the renderer's memory, or P% of what its pools would take: with less of it frames cost\n"
     "                      more (--stats), and are the same\n"},
    {RENDER | REPORT_BUG | FIRST,
     "  --frames N          so many: of an orbit, or the first ones of other cameras (all; of an orbit 16, or\n"
     "                      as many as all that moves takes)\n"},
    {RENDER | REPORT_BUG | FIRST,
     "  --gif FILE          all frames, animated; without --camera its end meets its beginning\n"},
    {RENDER | REPORT_BUG, "  --sheet FILE        up to 24 frames in one PNG file\n"},
    {RENDER | REPORT_BUG,
     "  --ids FILE          face numbers: uint32 little-endian a pixel, 0 = background; merges no faces\n"},
    {RENDER | REPORT_BUG, "  --fps N             frames a second of what moves, and of --gif (15)\n"},
    {RENDER | REPORT_BUG,
     "  --overlay TEXT      a text over each frame, as firmware draws it; each # in it becomes the frame's number\n"},
    {RENDER | REPORT_BUG | FIRST, "  --stats             what each frame cost\n"},
    {RENDER | REPORT_BUG | FIRST,
     "  --brief             --stats and --compare without a line a frame: mean and worst\n"},
    {RENDER | REPORT_BUG,
     "  --newell LIST       planes: compare with planes before rectangles; one: split one of two;\n"
     "                      most=N: at most so many comparisons a frame (256 times the square of the polygons)\n"},
    {RENDER | REPORT_BUG | FIRST, "  --compare           how each frame differs from the double-precision reference\n"},
    {RENDER | REPORT_BUG, "  --write-hashes FILE a hash a frame\n"},
    {RENDER | REPORT_BUG, "  --write-cameras FILE  the cameras as a C header, for firmware of this scene\n"},
    {RENDER | REPORT_BUG, "  --check FILE        compare with such a file; exit status 1 if a frame differs\n"},
    {0, "measure:\n"},
    {0, "  --camera, --size, --fov, --near, --unlit, --keep-faces, --method, --tree, --splitter, --delta as above\n"},
    {MEASURE | FIRST,
     "  -o DIR              measure.md, measure.csv, stages.csv and measure.png; their column shimmer is the share\n"
     "                      of changing pixels that have their colour back within 3 frames, of a turn of 0.011\n"
     "                      degrees a frame and of a walk of 1 mm a frame\n"},
    {MEASURE | FIRST,
     "  --precision LIST    names, divided by commas (the four profiles); fast_4: fast with 4 sub-pixel bits\n"},
    {MEASURE, "  --sub-bits          fast_4, fast_5, fast_8 and fine_6, too: each is compiled first\n"},
    {MEASURE | FIRST, "  --core LIST         processors: m0plus, m3, m4, m33, rv32 (all)\n"},
    {MEASURE, "  --optimise NAME     what the code is for: speed, balance or size (speed: -O2; the others: -Os)\n"},
    {MEASURE | COMPARE | FIRST, "  --no-cost           accuracy only: takes neither compilers nor emulators\n"},
    {MEASURE | ALONE,
     "  --result FILE       its figures in one file, for `limner sweep --merge`, with hashes of all that was read\n"},
    {0, "sweep, which takes what measure takes, but for --result, for all of its jobs:\n"},
    {SWEEP,
     "  -o DIR              jobs, one a line, slurm.sh, which makes an array of them, and results.list\n"
     "  --precision LIST    names, divided by commas (the four profiles)\n"
     "  --method LIST       names, divided by commas; auto: what compile chooses (auto)\n"
     "  --merge DIR         no jobs: their results become sweep.csv; with instructions front.csv, the means of each\n"
     "                      setting over all models, and front.png. Refused: results that are missing, of another\n"
     "                      version, or of files that have changed since\n"},
    {0, "compare:\n"},
    {0, "  --camera, --size, --fov, --near, --unlit, --keep-faces, --no-cost as above\n"},
    {COMPARE | FIRST,
     "  -o DIR              compare.md, compare.csv, and in red what is wrong: sheet.png, METHOD.png\n"},
    {COMPARE | FIRST, "  --precision NAME    (fast)\n"},
    {COMPARE | FIRST, "  --core LIST         processors (m0plus,m4); without their tools: dashes\n"},
    {COMPARE, "  --frames N          of the cameras, evenly chosen (all)\n"},
    {COMPARE, "  --cost-frames N     of these, for instructions (4)\n"},
    {0, "worst and report take what compile takes of a scene, --camera (report) and --fov as above, and:\n"},
    {WORST | ALONE | FIRST,
     "  -o PATH             PATH.cam, for render, PATH-cost.png, PATH-error.png and PATH-difference.png\n"},
    {PAGE | ALONE | FIRST, "  -o FILE.html        the page: one file, which loads nothing\n"},
    {ONE | FIRST,
     "  --seconds S         how long to search (20; with --tries or without --time-limit: as long as all tries)\n"
     "  --tries N           cameras for what costs most, a tenth as many for what errs most (2000)\n"
     "  --seed N            of the search (0)\n"},
    {ONE | ALONE | FIRST,
     "  --core LIST         processors to count instructions on: m0plus, m3, m4, m33, rv32 (none)\n"},
    {0, "walk, which takes what says how a MODEL is to be read:\n"},
    {WALK | FIRST,
     "  -o FILE.cam         the cameras, a line a frame\n"
     "  --frames N          so many (256)\n"
     "  --stride M          from one to the next, metres (0.25)\n"
     "  --from X,Y,Z        where the eye begins, over ground (a map's first player; else where most can be\n"
     "                      reached from)\n"
     "  --heading DEG       where it looks then: 0 along -z, 90 along -x (0)\n"
     "  --eye M             above its feet (1.6; in maps, as the next three, a player's: 1.28)\n"
     "  --height M          of the walker (1.75)\n"
     "  --radius M          half of its width, which is more than what the near plane reaches (0.25; 0.5)\n"
     "  --step M            how high a step it climbs (0.4; 0.75)\n"},
    {0, "splitters: --tree, --tolerance, --size, --near, --unlit, --keep-faces as above\n"},
    {0, "play: what view takes, but for a MODEL's own panel; loops until it is ended, unless there is --frames\n"},
    {MODULES | FIRST, "  --panel NAME        the display's controller, as render's --panel, perhaps with a format\n"},
    {PLAY | FIRST, "  --spi DEVICE        as /dev/spidev0.0\n"},
    {PLAY | FIRST,
     "  --hid [SERIAL]      instead: a USB-HID bridge, MCP2210 (the only one; =SERIAL if it is no number);\n"
     "                      its lines are GP0 to GP8\n"},
    {PLAY, "  --cs LINE           of a bridge: chip select (tied low)\n"},
    {PLAY | FIRST,
     "  --dc, --reset, --backlight, --te, --select LINE  GPIO lines by name or CHIP:NUMBER (not wired)\n"},
    {MODULES, "  --hz N, --mode 0-3  of the bus (as is usual with that controller)\n"},
    {PLAY, "  --no-cs, --cs-high  what the bus selects with\n"},
    {MODULES | FIRST, "  --size WxH          of the glass, upright\n"},
    {MODULES, "  --offset X,Y        of the glass's corner in the chip's memory\n"},
    {MODULES,
     "  --memory WxH        what the module's mode pins leave of the chip's memory (as is usual for that size)\n"},
    {MODULES, "  --start-line N      memory's line that the glass begins with, where the chip is told one (0)\n"},
    {MODULES | FIRST, "  --rotate DEG        the picture, clockwise\n"},
    {MODULES, "  --mirror            the picture's left and right exchanged\n"},
    {MODULES, "  --mirror-columns, --mirror-rows  of the glass, however the picture is turned\n"},
    {MODULES, "  --bgr, --rgb, --invert, --no-invert  if colours are wrong (as is usual with that controller)\n"},
    {MODULES, "  --contrast N        1 to what the chip takes (as is usual with that controller)\n"},
    {MODULES, "  --wiring sequential|alternative  of the lines of mono OLEDs (as is usual for that size)\n"},
    {MODULES, "  --converter         the controller's own one makes the glass's voltage (from outside): ssd0323\n"},
    {PLAY, "  --frames N          ends after so many\n"},
    {PLAY | FIRST, "  --test-card         instead of a scene: corners clockwise red, green, blue and a grey ramp\n"},
    {0, "module: --panel, --hz, --mode and what follows --size, but for --frames and --test-card, as play\n"},
    {MODULE | ALONE | FIRST, "  -o NAME             NAME.c and NAME.h\n"},
    {0, "card: --panel and the module's options as above; -o FILE.png, --write-hashes FILE, --check FILE\n"},
    {CARD | ALONE, "  -o FILE.png         the picture\n"},
    {CARD | HASHES | ALONE, "  --write-hashes FILE its hash\n"},
    {CARD | HASHES | ALONE, "  --check FILE        compare with such a file; exit status 1 if it differs\n"},
    {CARD | HASHES | ALONE,
     "  --check-loop FILE   the same, for frames that are shown for ever, seen from any of them on\n"},
    {DECODE,
     "decode: --panel and the module's options as above; FILE is a wire log: lines `b XX ...` for bytes, `p NAME 0|1`\n"
     "        for levels of dc, reset, select, backlight, cs and led, which ends frames, `t NANOSECONDS`, `# ...`\n"},
    {DECODE,
     "  --qemu MAP          instead: what QEMU prints with -trace memory_region_ops_write; MAP says which registers\n"
     "                      are which wires: `spi ADDRESS`, `pin NAME bsrr|clear|masked|output ADDRESS BIT`\n"},
    {DECODE,
     "  --foreign           the log is of somebody else's driver: what glass would bear is told, and no error\n"},
    {DECODE, "  or a logic analyser's capture: a VCD, or sigrok's session (.sr)\n"},
    {DECODE,
     "  --wires dc=D0,...   which channels are dc, sck, mosi, cs, reset, select, backlight and led (those with usual\n"
     "                      names: DC RS A0, SCK SCLK CLK, MOSI SDA DIN, CS CE SS, RST RES, BL, LED); cs=-: none\n"},
    {DECODE, "  --running           the firmware was started before the capture: the display is taken for one that is "
             "set up\n"},
    {DECODE,
     "  --pause US          a frame ends where nothing comes for so long (without led: where the picture is whole)\n"},
    {DECODE, "  --frames N          ends after so many (all)\n"},
    {DECODE | FIRST, "  -o PATTERN, --write-hashes FILE, --check FILE  as render\n"},
    {DECODE, "  --check-loop FILE   of frames that are shown for ever, seen from any of them on\n"},
    {0, "hashes: --write-hashes FILE, --check FILE as render; --shrink N: a pixel is NxN of the picture's (1)\n"},
    {0, "formats: --markdown: as tables for a page\n"},
    {FORMATS | ALONE, "  --markdown          as tables for a page\n"},
    {HASHES | ALONE, "  --shrink N          a pixel is NxN of the picture's (1)\n"},
    {0, "report-bug: what render takes; pictures are left out\n"},
    {BRIDGE | ALONE | FIRST, "  --panel NAME, --size WxH  of one display alone (all that there are, of usual sizes)\n"},
    {UF2 | ALONE, "  -o IMAGE.uf2        the file\n"
                  "  --family NAME       the processor: rp2040, rp2350-arm-s\n"},
    {BOOT2 | ALONE, "  -o NAME.c           the file\n"},
    {ESPIMAGE | ALONE, "  -o IMAGE.esp        the file\n"
                       "  --chip NAME         the processor: esp32c3\n"},
    {REPORT_BUG | FIRST,
     "  -o FILE             the report (limner-report.tar): a tar archive of the model, the files that it names,\n"
     "                      cameras, options, versions and a hash a frame\n"},
    {0, "export, which takes what compile takes, and a display as play does:\n"},
    {EXPORT | FIRST, "  --for WORLD         arduino (PlatformIO, too), idf, pico, cmake or plain\n"
                     "  -o FOLDER           to write; one that an export wrote, unchanged, is written anew\n"},
    {0, "replay:\n"},
    {REPLAY | FIRST, "  -o FILE             the report anew, with what comes out now\n"},
    {0, "all that take a MODEL, which may be a map of Doom or Freedoom, FILE.wad:MAP or IWAD.wad+PWAD.wad:MAP:\n"},
    {MODELS | REPLAY | WALK | DECODE,
     "  --time-limit SECONDS  then the best so far counts, said as such; nothing yet is an error (600, or\n"
     "                      LIMNER_TIME_LIMIT in the environment; 0: none). play and view: until they fly; decode\n"
     "                      from a pipe: none, unless it is given here\n"},
    {0, "environment:\n"},
    {MODELS | REPLAY | WALK,
     "  LIMNER_PROGRESS=10  seconds between lines of what long work does, where standard error is no terminal (10;\n"
     "                      0: none)\n"},
    {MODELS | REPLAY | WALK, "  LIMNER_CACHE=DIR    where it remembers how models are best drawn (~/.cache/limner)\n"},
    {RENDER | VIEW, "  LIMNER_DUMP=x.png   write the last frame shown\n"},
    {RENDER | VIEW, "  LIMNER_CHECK=x.png  compare it; exit status 1 if it differs\n"},
    {VIEW, "  LIMNER_UNSEEN=1     view: SDL's video drivers dummy and offscreen, which show nothing, do for a window\n"
           "                      (the terminal takes over)\n"},
};

enum { COMMAND_COUNT = sizeof COMMANDS / sizeof COMMANDS[0], ENTRY_COUNT = sizeof ENTRIES / sizeof ENTRIES[0] };

const struct usage_command *usage_command_at(size_t index)
{
    return index < COMMAND_COUNT ? &COMMANDS[index] : NULL;
}

const struct usage_entry *usage_entry_at(size_t index)
{
    return index < ENTRY_COUNT ? &ENTRIES[index] : NULL;
}

bool usage_is_alone(const struct usage_entry *entry)
{
    return entry->commands & ALONE;
}

static void print_commands(FILE *out)
{
    fputs("usage: limner COMMAND ...; limner COMMAND --help tells that command's options, --help all the rare ones, "
          "too; limner help: this text\n\n",
          out);
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        fprintf(out, "       limner %s%s%s\n           %s\n", COMMANDS[i].name, *COMMANDS[i].arguments ? " " : "",
                COMMANDS[i].arguments, COMMANDS[i].what);
    fputc('\n', out);
}

void usage_print(FILE *out)
{
    print_commands(out);
    for (size_t i = 0; i < ENTRY_COUNT; i++)
        if (!(ENTRIES[i].commands & ALONE)) fputs(ENTRIES[i].text, out);
    fprintf(out, "\nkeys of view: %s\n", FLY_HELP);
}

/* Few options are told whole. */
enum { TOLD_WHOLE = 14 };

static size_t count_options(uint32_t bit)
{
    size_t count = 0;
    for (size_t i = 0; i < ENTRY_COUNT; i++)
        count += (ENTRIES[i].commands & bit) != 0;
    return count;
}

static bool is_output(const struct usage_entry *entry)
{
    return strncmp(entry->text, "  -o ", 5) == 0;
}

/* Those with all bits of `with` and none of `without`; what names the output before the others. */
static void print_entries(uint32_t with, uint32_t without, FILE *out)
{
    for (int outputs = 1; outputs >= 0; outputs--)
        for (size_t i = 0; i < ENTRY_COUNT; i++)
            if ((ENTRIES[i].commands & with) == with && !(ENTRIES[i].commands & without) &&
                is_output(&ENTRIES[i]) == outputs)
                fputs(ENTRIES[i].text, out);
}

static void print_options(const struct usage_command *command, bool all, FILE *out)
{
    const uint32_t bit = UINT32_C(1) << (command - COMMANDS);
    const size_t count = count_options(bit);
    if (!count) return;
    fputs("\noptions:\n", out);
    if (count <= TOLD_WHOLE) {
        print_entries(bit, 0, out);
        return;
    }
    print_entries(bit | FIRST, 0, out);
    if (!all) {
        fprintf(out, "\nmore options: limner %s --help all\n", command->name);
        return;
    }
    fputs("\nmore options:\n", out);
    print_entries(bit, FIRST, out);
}

bool usage_print_command(const char *name, bool all, FILE *out)
{
    for (const struct usage_command *at = COMMANDS; at < COMMANDS + COMMAND_COUNT; at++) {
        if (strcmp(at->name, name) != 0) continue;
        fprintf(out, "usage: limner %s%s%s\n%s\n", name, *at->arguments ? " " : "", at->arguments, at->what);
        print_options(at, all, out);
        if (strcmp(name, "view") == 0) fprintf(out, "\nkeys: %s\n", FLY_HELP);
        fprintf(out, "\nexample:\n  %s\n", at->example);
        return true;
    }
    return false;
}
