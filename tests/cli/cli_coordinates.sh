# SPDX-License-Identifier: MIT
#
# --coordinates: what 16 bits refuse, 32 hold; what 16 bits hold stays as it is; what cannot have 32 is refused in one line;
# and all commands that take a scene take a long one.
. tests/tap.sh
. tests/part_of.sh
. tests/scene_program.sh
. tests/refused.sh
. tests/long_scene.sh

limner=$(cd "$BUILD" && pwd)/limner
long_scene "$work/many"
long_scene "$work/glassy" 0.5
textured_long_scene "$work/textured" tests/models/quarters.png
textured_long_scene "$work/masked" tests/models/quarters.png tests/models/holes.png
demo=$BUILD/scenes/textured/textured.obj
many=$work/many.obj cameras=$work/many.cam

# Which coordinates ------------------------------------------------------------------------------------------------------

tap_check "16 bits refuse a ground of 240 km with boxes of 0.6 m, and name faces and the unit" refused \
    'many.obj: face [0-9]+ \(0.6 m\), .* of 181 faces would vanish or move too far on a grid with units of 3.66 m' \
    compile "$many" --coordinates 16 -o "$work/out/many"
tap_check "no other number of bits" refused '^limner: --coordinates 17: no such choice; there are auto, 16 and 32$' \
    compile "$many" --coordinates 17 -o "$work/out/many"

auto_takes_32() {
    "$limner" compile "$many" -o "$work/many" --report >"$work/report" && grep 'coordinates  *32 bits' "$work/report" &&
        grep -A 1 '^#ifndef LIM_HAS_LONG$' "$work/many.h" | grep '^#define LIM_HAS_LONG 1$' &&
        grep 'struct lim_long_vertex' "$work/many.c"
}
tap_check "auto takes 32 bits for it" auto_takes_32

measure_tells_the_scales() {
    "$limner" measure "$many" --no-cost --size 32x32 --precision fast --camera "$cameras" -o "$work/measured" >"$work/said" &&
        grep '^Scales: the model is 240000 m long, its smallest surface 0.6 m, 1 to 400000. Coordinates have 32 bits' "$work/measured/measure.md" &&
        awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
            { print $column["coordinate_bits"], $column["unit_m"], $column["longest_m"], $column["smallest_m"]
              exit !($column["coordinate_bits"] == 32 && $column["longest_m"] == 240000 && $column["smallest_m"] == 0.6 &&
                     $column["unit_m"] < 0.001) }' "$work/measured/measure.csv"
}
tap_check "measure tells how far the scales are apart" measure_tells_the_scales

textures_do_not_keep_16_bits() {
    refused 'textured.obj: face [0-9]+ .* would vanish or move too far on a grid with units of 3.66 m' \
        compile "$work/textured.obj" --coordinates 16 -o "$work/out/many" &&
        "$limner" compile "$work/textured.obj" -o "$work/textured" --report >"$work/report" && grep 'coordinates  *32 bits' "$work/report" &&
        ! grep 'no texture coordinates' "$work/report" && grep '^#define LIM_HAS_LONG 1$' "$work/textured.h" &&
        grep '^#define LIM_HAS_TEXTURE 1$' "$work/textured.h" && grep 'struct lim_long_mapping' "$work/textured.c"
}
tap_check "textures or not" textures_do_not_keep_16_bits

auto_is_as_16() { # MODEL
    "$limner" compile "$1" -o "$work/auto" --report >"$work/auto.report" &&
        "$limner" compile "$1" --coordinates 16 -o "$work/short" --report >"$work/short.report" &&
        grep -A 1 '^#ifndef LIM_HAS_LONG$' "$work/auto.h" | grep '^#define LIM_HAS_LONG 0$' &&
        ! grep 'lim_long_\|of_32_bits' "$work/auto.c" && cmp "$work/auto.lim" "$work/short.lim"
}
for scene in sim/scenes/rooms.obj sim/scenes/teapot.obj sim/scenes/glass.obj "$demo"; do
    tap_check "$(basename "$scene" .obj) keeps 16 bits, and is what it would be without the option" auto_is_as_16 "$scene"
done

# What 16 bits refuse for their near plane, their eyes or a precision, 32 draw: a floor of so many metres either way, with a
# square of 0.2 m on end.
floor() { # HALF-SIDE
    awk -v half="$1" 'BEGIN {
        print "v", -half, 0, -half "\nv", -half, 0, half "\nv", half, 0, half "\nv", half, 0, -half
        print "v 0 0 0\nv .2 0 0\nv .2 .2 0\nv 0 .2 0\nf 1 2 3 4\nf 5 6 7 8" }'
}
echo '0.1 0.3 1 0.1 0.1 0' >"$work/square.cam"
echo '0 0 100 0 0 0' >"$work/far.cam"
printf 'v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nf 1 2 3 4\n' >"$work/square.obj"
is_right() { # MODEL CAMERAS OPTION...
    right_model=$1 right_cameras=$2
    shift 2
    "$limner" render "$right_model" --camera "$right_cameras" --compare "$@" >"$work/said" && tail -n 1 "$work/said" &&
        awk '/^compared/ { wrong = $8 } END { exit !(wrong != "" && wrong <= 0.3) }' "$work/said"
}
for half in 1500 5000 50000 500000; do
    floor $half >"$work/floor.obj"
    for precision in fast fine exact; do
        tap_check "a square of 0.2 m on a floor of $half m either way, $precision" is_right "$work/floor.obj" "$work/square.cam" \
            --precision $precision
    done
    tap_check "a near plane of 0.1 m there" is_right "$work/floor.obj" "$work/square.cam" --near 0.1
done
tap_check "an eye that is 100 m from a square of 4 m" is_right "$work/square.obj" "$work/far.cam" --fov 3
tap_check "16 bits refuse that, and 32 are named" refused 'far.cam:1: the eye is too far .*, farther with --coordinates 32$' \
    render "$work/square.obj" --camera "$work/far.cam" --fov 3 --coordinates 16 -o "$work/out/%d.png"
floor 5000 >"$work/floor.obj"
tap_check "and the near plane" refused 'nothing nearer than .*; take --coordinates 32$' \
    render "$work/floor.obj" --coordinates 16 --near 0.1 --precision exact -o "$work/out/%d.png"
tap_check "and what the near plane cuts away" refused 'smaller than the distance .*; take --coordinates 32, or give --near 0.61$' \
    compile "$work/floor.obj" --coordinates 16 --precision exact -o "$work/out/x"
tap_check "a method that cannot have 32 bits is told so" refused 'take a method that walks a tree, .*, or give --near 0.61$' \
    render "$work/floor.obj" --method newell --precision exact -o "$work/out/%d.png"

# The same model on both grids: the pictures are as the reference has them.
rooms_with_32_bits() {
    "$limner" render sim/scenes/rooms.obj --coordinates 32 --camera sim/scenes/rooms.cam --size 80x60 --compare >"$work/said" &&
        tail -n 1 "$work/said" && awk '{ for (i = 2; i <= NF; i++) if ($(i - 1) == "wrong") { n++; if ($i > 0.05) bad = 1 } }
            END { exit bad || !n }' "$work/said"
}
tap_check "rooms with 32 bits, asked for, are drawn as the reference has them" rooms_with_32_bits

# Macros of the header ---------------------------------------------------------------------------------------------------

# The camera of a line of many.cam, put there by macros: the pixels are those of the host's frame.
prepare_program() {
    cat >"$work/main.c" <<'END'
#include "limner.h"
#include "many.h"
#include <stdio.h>
static uint16_t line[64];
static uint32_t hash = 2166136261u;
static void *lend(void *ctx, uint16_t y_px) { (void)ctx, (void)y_px; return line; }
static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    (void)ctx, (void)y_px;
    for (uint16_t x = x_px; x < x_px + n_px; x++) hash = (hash ^ line[x]) * 16777619u;
    return 0;
}
static uint32_t mem[MANY_SCENE_MEM_B(64) / 4 + 1];
int main(void)
{
    static const int32_t eye[] = MANY_POINT(EYE_X, EYE_Y, EYE_Z);
    const struct lim_target target = {.w_px = 64, .h_px = 64, .method = MANY_SCENE_METHOD, .lend = lend, .done = done};
    struct lim_camera camera = {.tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28, .near_q8 = MANY_M_Q8(0.01)};
    static struct lim lim;
    for (int i = 0; i < 3; i++)
        camera.origin[i] = eye[i];
    camera.yaw = LIM_DEGREES(YAW);
    printf("%ld %ld %ld %ld %ld %ld %ld\n", (long)eye[0], (long)eye[1], (long)eye[2], (long)MANY_X(EYE_X), (long)MANY_Y(EYE_Y),
           (long)MANY_Z(EYE_Z), (long)MANY_UNITS(1000));
    if (lim_init(&lim, &many_scene, &target, mem, sizeof mem) || lim_frame(&lim, &camera)) return 1;
    return hash == 2166136261u;
}
END
    scene_program "$work/main" -DLIM_CONFIG='"many.h"' -DEYE_X=1234.5 -DEYE_Y=-7.25 -DEYE_Z=-119999.75 -DYAW=30 "$work/main.c" "$work/many.c"
}
tap_check "a program compiles with the header's macros, without a warning" prepare_program

# What many.h says of itself, computed by awk: units are (metre - origin) * units per metre, to nearest.
macros_put_it_there() {
    "$work/main" >"$work/placed" || return 1
    awk '$1 == "#define" && $2 == "MANY_UNITS_PER_M" { scale = $3 }
        $1 == "#define" && $2 ~ /^MANY_ORIGIN_[XYZ]_M$/ { origin[substr($2, 13, 1)] = $3 }
        function units(metres, axis) { return sprintf("%.0f", (metres - origin[axis]) * scale) }
        END {
            x = units(1234.5, "X"); y = units(-7.25, "Y"); z = units(-119999.75, "Z")
            print x, y, z, x, y, z, sprintf("%.0f", 1000 * scale)
        }' "$work/many.h" >"$work/wanted"
    cat "$work/placed" && diff "$work/wanted" "$work/placed"
}
tap_check "and they put a place where the header says that it is" macros_put_it_there

# Each camera of the file as C has the place that the file says: in whole units, and what is left of one with 8 fraction
# bits.
cameras_are_where_the_file_says() {
    "$limner" render "$work/many.lim" --camera "$cameras" --size 32x32 --write-cameras "$work/cameras.h" >/dev/null || return 1
    awk '$1 == "#define" && $2 == "MANY_UNITS_PER_M" { scale = $3 }
        $1 == "#define" && $2 ~ /^MANY_ORIGIN_[XYZ]_M$/ { origin[++axes] = $3 }
        FILENAME ~ /cam$/ { count++; for (i = 1; i <= 3; i++) metres[count, i] = $i }
        /^    \{\{/ {
            frame++
            gsub(/[^-0-9]+/, " ")
            if (split($0, number, " ") != 12) bad = 1
            for (i = 1; i <= 3; i++) {
                off = (metres[frame, i] - origin[i]) * scale - (number[9 + i] + number[i] / 256)
                if (off < -0.004 || off > 0.004 || number[i] < 0 || number[i] > 255) { print frame, i, off; bad = 1 }
            }
        }
        END { exit bad || frame != 12 || count != 12 }' "$work/many.h" "$cameras" "$work/cameras.h"
}
tap_check "--write-cameras puts each of the file where it says" cameras_are_where_the_file_says

# What cannot have 32 bits -----------------------------------------------------------------------------------------------

for options in '--method mesh' '--method mesh-depth' '--method newell' '--method depth' \
    '--mesh-leaves all' '--tree mesh' '--tree none' --drop-small; do
    # shellcheck disable=SC2086 # options are words
    tap_check "$options: refused with 32 bits" refused ': --coordinates 32: not with --drop-small, mesh leaves, or methods that do not walk a tree' \
        compile sim/scenes/rooms.obj $options --coordinates 32 -o "$work/out/scene"
done
tap_check "a solid by its own method: refused with 32 bits" refused ': --coordinates 32: not with --drop-small, mesh leaves, or methods that do not walk a tree' \
    compile sim/scenes/icosahedron.obj --method convex --coordinates 32 -o "$work/out/scene"

# What moves ---------------------------------------------------------------------------------------------------------------

# The scene of movers, its first mesh 50,000 times as large: what stands still alone would have 32 bits.
movers_on_a_large_ground() {
    sed 's/^\( *\)\(.*\){"mesh": 0}/\1\2{"mesh": 0, "scale": [50000, 1, 50000]}/' sim/scenes/movers.gltf >"$work/movers.gltf"
    ! cmp -s sim/scenes/movers.gltf "$work/movers.gltf" && "$limner" compile "$work/movers.gltf" -o "$work/out/movers" --report >"$work/said" &&
        grep -q 'coordinates *32 bits' "$work/said" && grep -q '^#define LIM_HAS_LONG 1$' "$work/out/movers.h" &&
        grep -q 'origins1' "$work/out/movers_movers.c"
}
tap_check "auto gives 32 bits to what moves on a large ground" movers_on_a_large_ground
tap_check "and with 16 refuses what they do not hold" refused 'faces would vanish or move too far on a grid with units of' \
    compile "$work/movers.gltf" --coordinates 16 -o "$work/out/movers"
for tree in clusters axis; do
    tap_check "--tree $tree: refused where something moves in 32 bits" \
        refused ": --tree $tree: in a scene with coordinates of 32 bits nothing moves in a tree with leaves" \
        compile sim/scenes/movers.gltf --tree $tree --coordinates 32 -o "$work/out/movers"
done
moving_pixels() { # BITS
    "$limner" render sim/scenes/movers.gltf --coordinates "$1" --camera sim/scenes/movers.cam --size 80x60 --compare \
        >"$work/said" 2>&1 && sed -n 's/.*wrong \([0-9.]*\) %.*holes \([0-9]*\).*/\1 \2/p' "$work/said" | tail -n 1
}
movers_are_as_right() {
    long=$(moving_pixels 32) && short=$(moving_pixels 16) && echo "32: $long, 16: $short" &&
        awk -v long="$long" -v short="$short" 'BEGIN { split(long, l); split(short, s); exit !(l[2] == 0 && l[1] <= 0.1 && l[1] <= 2 * s[1] + 0.02) }'
}
tap_check "what moves is as right with 32 bits, without holes" movers_are_as_right
movers_as_c_compile() {
    "$limner" compile sim/scenes/movers.gltf --coordinates 32 -o "$work/out/far" --report >"$work/said" || return 1
    for file in "$work"/out/far*.c; do
        # shellcheck disable=SC2086 # the flags are a list
        ${CC:?is set by the Makefile} -std=c11 ${WARNINGS:?is set by the Makefile} -fsyntax-only -Ifirmware "-I$work/out" -DLIM_CONFIG='"far.h"' "$file" || return 1
    done
}
tap_check "its C compiles without a warning" movers_as_c_compile

# Methods ----------------------------------------------------------------------------------------------------------------

hashes() { # FILE MODEL OPTION...
    hashes_file=$1
    shift
    "$limner" render "$@" --camera "$cameras" --size 80x60 --write-hashes "$hashes_file" >"$work/said" 2>&1 ||
        { cat "$work/said"; return 1; }
}

# Nearest first's picture, by the scene that --method makes, and by the one that is there.
is_the_same_by() { # MODEL OPTION...
    by_model=$1
    shift
    hashes "$work/nearest" "$by_model" --method bsp && hashes "$work/other" "$by_model" "$@" &&
        diff "$work/nearest" "$work/other" && [ "$(cut -d ' ' -f 2 "$work/nearest" | sort -u | wc -l)" -eq 12 ]
}
# With the same option for both.
is_the_same_with() { # MODEL METHOD OPTION...
    with_model=$1 with_method=$2
    shift 2
    hashes "$work/nearest" "$with_model" --method bsp "$@" && hashes "$work/other" "$with_model" --method "$with_method" "$@" &&
        diff "$work/nearest" "$work/other"
}
for precision in $(part_of 2 draft fast fine exact); do # the others: tests/part_of.sh
    tap_check "$precision: scan lines paint nearest first's picture" is_the_same_with "$many" scanline --precision $precision
    tap_check "$precision: and so does the painter" is_the_same_with "$many" painter --precision $precision
    tap_check "$precision: scan lines paint nearest first's texels" is_the_same_with "$work/textured.obj" scanline --precision $precision
    tap_check "$precision: and so does the painter" is_the_same_with "$work/textured.obj" painter --precision $precision
    tap_check "$precision: and the painter round holes" is_the_same_with "$work/masked.obj" painter --precision $precision
    tap_check "$precision: and the painter with glass" is_the_same_with "$work/glassy.obj" painter --precision $precision
done
tap_check "antialiased: scan lines paint nearest first's picture" is_the_same_with "$many" scanline --antialias
tap_check "antialiased: scan lines paint nearest first's texels" is_the_same_with "$work/textured.obj" scanline --antialias
tap_check "clusters show nearest first's picture" is_the_same_by "$many" --method clusters
tap_check "axis cuts show nearest first's picture" is_the_same_by "$many" --method axis
tap_check "a framebuffer shows nearest first's picture" is_the_same_by "$many" --method bsp --panel framebuffer
tap_check "a framebuffer shows it painted from back to front" is_the_same_by "$many" --method painter --panel framebuffer
tap_check "a framebuffer shows glass" is_the_same_by "$work/glassy.obj" --panel framebuffer
tap_check "a framebuffer shows texels" is_the_same_by "$work/textured.obj" --panel framebuffer
tap_check "a framebuffer shows texels round holes" is_the_same_by "$work/masked.obj" --panel framebuffer
tap_check "changes alone leave the same texels" is_the_same_by "$work/textured.obj" --method bsp --delta
tap_check "little memory shows the same texels" is_the_same_by "$work/masked.obj" --method bsp --ram 60%
tap_check "changes alone leave the same frames" is_the_same_by "$many" --method bsp --delta
tap_check "little memory shows the same frames" is_the_same_by "$many" --method bsp --ram 60%
tap_check "little memory shows the same glass" is_the_same_by "$work/glassy.obj" --method bsp --ram 60%

wireframe() {
    hashes "$work/solid" "$many" && hashes "$work/wires" "$many" --wireframe && ! diff "$work/solid" "$work/wires" >/dev/null &&
        hashes "$work/wires_of_little" "$many" --wireframe --ram 60% && diff "$work/wires" "$work/wires_of_little"
}
tap_check "a wireframe is another picture, the same with little memory" wireframe

# Textures ---------------------------------------------------------------------------------------------------------------

texels() { # COLUMN: of each profile, draft to exact
    awk -F , -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } { printf "%s ", $at[name] } END { print "" }' "$work/measured/measure.csv"
}

# The bounds of cli_texture.sh.
demo_shows_its_texels() {
    "$limner" measure "$demo" --camera "${demo%.obj}.cam" --coordinates 32 --no-cost -o "$work/measured" >/dev/null &&
        texels texel_rms && texels texel_far_percent && texels texel_level_percent &&
        texels texel_rms | awk '{ exit !(NF == 4 && $1 < 0.5 && $2 < 0.1 && $3 < 0.03 && $4 < 0.01 && $1 > $2 && $2 > $3 && $3 > $4 && $4 > 0) }' &&
        texels texel_far_percent | awk '{ exit !(NF == 4 && $1 < 1 && $2 + $3 + $4 == 0) }' &&
        texels texel_level_percent | awk '{ exit !(NF == 4 && $1 < 12 && $2 < 12 && $3 < 12 && $4 < 12) }'
}
tap_check "the textured demo with 32 bits shows its texels as with 16" demo_shows_its_texels

ground_shows_its_texels() {
    "$limner" measure "$work/textured.obj" --camera "$cameras" --size 160x120 --no-cost -o "$work/measured" >/dev/null &&
        texels texel_far_percent && texels texel_level_percent &&
        texels texel_far_percent | awk '{ exit !(NF == 4 && $1 < 1 && $2 + $3 + $4 == 0) }' &&
        texels texel_level_percent | awk '{ exit !(NF == 4 && $1 < 12 && $2 < 12 && $3 < 12 && $4 < 12) }'
}
tap_check "a ground with 120,000 pictures along each side shows its texels" ground_shows_its_texels

# A wall all round, endlessly far away: with 32 bits the picture is that with 16, wherever the eye is.
sky_is_the_same() {
    sed -e 's/^v 0 0 0/v -9 -9 0/;s/^v 1 0 0/v 9 -9 0/;s/^v 1 1 0/v 9 9 0/;s/^v 0 1 0/v -9 9 0/' tests/models/quarters.obj >"$work/wide.obj"
    cp tests/models/quarters.* "$work" && mv "$work/wide.obj" "$work/quarters.obj" || return 1
    printf '0 0 1 0 0 -1\n0.4 0.2 1 0.4 0.2 -1\n' >"$work/two.cam"
    for bits in 16 32; do
        "$limner" render "$work/quarters.obj" --camera "$work/two.cam" --sky quarters --coordinates $bits --size 64x64 \
            --write-hashes "$work/sky$bits" 2>"$work/said" || return 1
    done
    cat "$work/sky16" "$work/sky32"
    cmp "$work/sky16" "$work/sky32" && [ "$(cut -d ' ' -f 2 "$work/sky32" | sort -u | wc -l)" = 1 ] &&
        "$limner" compile "$work/quarters.obj" --sky quarters --coordinates 32 -o "$work/sky" >/dev/null &&
        grep '^#define LIM_HAS_SKY 1$' "$work/sky.h" && grep '^#define LIM_HAS_LONG 1$' "$work/sky.h"
}
tap_check "a sky is what it is with 16 bits" sky_is_the_same

keeps_to_a_budget() {
    "$limner" compile "$work/textured.obj" --texture-budget 1 -o "$work/budget" --report >"$work/report" 2>&1 || { cat "$work/report"; return 1; }
    grep 'of these textures' "$work/report" && awk '/of these textures/ { exit !($4 <= 1000) }' "$work/report" &&
        grep '^#define LIM_HAS_LONG 1$' "$work/budget.h"
}
tap_check "textures keep to a budget" keeps_to_a_budget

# A firmware's own frames, with indices of 16 bits: the hashes are the host's.
program_shows_the_same_texels() { # NAME OPTION...
    name=$1
    shift
    "$limner" compile "$work/$name.obj" --size 64x64 "$@" -o "$work/program" >/dev/null &&
        "$limner" render "$work/$name.obj" --camera "$cameras" --size 64x64 "$@" --method bsp --write-cameras "$work/cameras.h" \
            --write-hashes "$work/of_host" >/dev/null 2>&1 || return 1
    cat >"$work/main.c" <<'END'
#include "limner.h"
#include "program.h"
#include "cameras.h"
#include <stdio.h>
static uint16_t pixels[64 * 64];
static void *lend(void *ctx, uint16_t y_px) { (void)ctx; return &pixels[64 * y_px]; }
static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px) { (void)ctx, (void)y_px, (void)x_px, (void)n_px; return 0; }
static uint32_t mem[PROGRAM_SCENE_MEM_B(64) / 2 + 64];
int main(void)
{
    const struct lim_target target = {.w_px = 64, .h_px = 64, .method = PROGRAM_SCENE_METHOD, .lend = lend, .done = done};
    static struct lim lim;
    if (lim_init(&lim, &program_scene, &target, mem, sizeof mem)) return 1;
    for (unsigned frame = 0; frame < CAMERAS_COUNT; frame++) {
        unsigned long long hash = 0xcbf29ce484222325u;
        if (lim_frame(&lim, &cameras[frame])) return 1;
        for (int i = 0; i < 64 * 64; i++) {
            const unsigned char *bytes = (const unsigned char *)&pixels[i];
            hash = (hash ^ bytes[0]) * 0x100000001b3u;
            hash = (hash ^ bytes[1]) * 0x100000001b3u;
        }
        printf("%u %016llx\n", frame, hash);
    }
    return 0;
}
END
    scene_program "$work/main" -DLIM_CONFIG='"program.h"' "$work/main.c" "$work/program.c" &&
        "$work/main" >"$work/of_program" && diff "$work/of_program" "$work/of_host"
}
tap_check "a program shows the host's texels" program_shows_the_same_texels textured
tap_check "and round holes, in profile exact" program_shows_the_same_texels masked --precision exact

# Files ------------------------------------------------------------------------------------------------------------------

file_draws_the_same() { # MODEL
    for precision in draft fast fine exact; do
        "$limner" compile "$1" --precision $precision -o "$work/file" >/dev/null &&
            hashes "$work/of_model" "$1" --precision $precision && hashes "$work/of_file" "$work/file.lim" --precision $precision &&
            diff "$work/of_model" "$work/of_file" || return 1
    done
}
tap_check "the .lim file draws what the model draws" file_draws_the_same "$many"
tap_check "the .lim file draws what textures draw" file_draws_the_same "$work/textured.obj"
tap_check "the .lim file draws what holes draw" file_draws_the_same "$work/masked.obj"
tap_check "the .lim file draws what glass draws" file_draws_the_same "$work/glassy.obj"

damaged() { # BYTE
    cp "$work/many.lim" "$work/damaged.lim"
    printf '\021' | dd of="$work/damaged.lim" bs=1 seek="$1" conv=notrunc 2>/dev/null
    refused 'damaged.lim: ' render "$work/damaged.lim" --camera "$cameras" --size 32x32 -o "$work/out/%d.png"
}
tap_check "a .lim file whose header is damaged is refused" damaged 144
tap_check "a .lim file whose vertices are damaged is refused" damaged 171

# Commands ---------------------------------------------------------------------------------------------------------------

tap_check "nobody walks there, and is told why" refused 'a scene with coordinates of 32 bits stops no walker' \
    walk "$many" -o "$work/out/walk.cam"

reports() {
    "$limner" report "$many" -o "$work/report.html" && grep -q '</html>' "$work/report.html" && ! sed 's/base64,[^"]*//g' "$work/report.html" | grep -i 'nan'
}
tap_check "limner report writes its page" reports

searches_the_worst() {
    "$limner" worst "$many" --size 64x64 >"$work/worst" && cat "$work/worst" && grep -q 'times the mean' "$work/worst"
}
tap_check "limner worst finds the dearest view" searches_the_worst

compares() {
    "$limner" render "$many" --camera "$cameras" --size 120x90 --compare >"$work/said" && tail -n 1 "$work/said" &&
        sed -n 's/.*wrong \([0-9.]*\) %.*/\1/p' "$work/said" | tail -n 1 | awk '{ seen = 1; exit !($1 <= 0.1) } END { if (!seen) exit 1 }'
}
tap_check "--compare finds at most 0.1 % of the pixels wrong" compares

has_an_orbit() {
    "$limner" render "$many" --frames 4 --size 32x32 -o "$work/orbit%d.png" && ls "$work"/orbit3.png
}
tap_check "an orbit around all of it is drawn" has_an_orbit
# The whole of a model is in an orbit's pictures: nothing but the background is at their edges, and more within.
orbit_shows_all() { # BITS
    "$limner" render sim/scenes/teapot.obj --coordinates "$1" --method nearest --frames 3 --size 64x64 -o "$work/orbit%d.png" &&
        PYTHONDONTWRITEBYTECODE=1 python3 - "$work" <<'END'
import sys
sys.path.insert(0, "tests/formats")
from formats import png_read
for frame in range(3):
    pixel = png_read("%s/orbit%d.png" % (sys.argv[1], frame))
    edges = {pixel(*at) for i in range(64) for at in ((i, 0), (i, 63), (0, i), (63, i))}
    inside = sum(pixel(x, y) not in edges for x in range(64) for y in range(64))
    if len(edges) != 1 or inside < 500:
        sys.exit("frame %d: %d colours at the edges, %d pixels within" % (frame, len(edges), inside))
END
}
for bits in 16 32; do
    tap_check "an orbit of $bits bits is so far out that all of it is seen" orbit_shows_all "$bits"
done

tap_done
