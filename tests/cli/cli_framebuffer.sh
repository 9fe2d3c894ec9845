# SPDX-License-Identifier: MIT
#
# A framebuffer: the same pictures as line by line, compiled for by nearest first or the painter's order, whichever the
# scene is better drawn by, with the memory that is said; what is drawn by lines alone is refused.
. tests/tap.sh
. tests/scene_program.sh

render() { "$BUILD/limner" render "$@" --size 97x61 >"$work/stats"; }

# SCENE TREE PROFILE: by both orders.
shows_the_same() {
    rm -f "$work/golden"
    set -- "sim/scenes/$1.obj" --camera "sim/scenes/$1.cam" --tree "$2" --precision "$3"
    render "$@" --panel memory --write-hashes "$work/golden" &&
        for method in nearest painter; do
            render "$@" --panel framebuffer --method $method --check "$work/golden" || return 1
        done
}
for profile in draft fast fine exact; do
    tap_check "rooms, $profile: the same pictures by both orders" shows_the_same rooms bsp $profile
    tap_check "teapot, $profile: the same pictures by both orders" shows_the_same teapot clusters $profile
done

# So are those that come by lines: what is not made of whole colours, or moves.
by_lines_too() { # SCENE OPTION...
    scene=$1
    shift
    render "$scene" "$@" --panel memory --write-hashes "$work/lines" &&
        render "$scene" "$@" --panel framebuffer --check "$work/lines"
}
tap_check "glass" by_lines_too sim/scenes/glass.obj
tap_check "glass by the painter" by_lines_too sim/scenes/glass.obj --method painter
tap_check "what moves" by_lines_too sim/scenes/movers.gltf
tap_check "what alone changes" by_lines_too sim/scenes/rooms.obj --delta
tap_check "outlines" by_lines_too sim/scenes/rooms.obj --wireframe
tap_check "smooth edges" by_lines_too sim/scenes/rooms.obj --antialias
tap_check "what is sorted" by_lines_too sim/scenes/knot.obj --method newell

# SCENE, what the report says of the order
compiled() {
    "$BUILD/limner" compile "sim/scenes/$1.obj" --framebuffer --size 128x64 -o "$work/model" --report >"$work/report" &&
        cat "$work/report" && grep -q "^RAM at 128x64 pixels, $2\$" "$work/report" &&
        grep -qE '^  framebuffer, bytes +16384$' "$work/report" && grep -qx '#define LIM_HAS_FRAMEBUFFER 1' "$work/model.h" &&
        grep -qxF '#define MODEL_SCENE_LINES(h_px) (h_px)' "$work/model.h"
}
tap_check "rooms hide much: nearest first" compiled rooms 'nearest first'
tap_check "a teapot hides little: back to front" compiled teapot 'back to front'
tap_check "so does one convex solid" compiled icosahedron 'back to front'
lines_are_wide() {
    "$BUILD/limner" compile sim/scenes/rooms.obj --framebuffer --size 97x61 --report >"$work/report" &&
        grep -qE '^  framebuffer, bytes +11956$' "$work/report"
}
tap_check "lines begin at whole words" lines_are_wide

# The memory that the header names is what the firmware of that header asks for, and least where nothing waits.
cat >"$work/main.c" <<'END'
#include "limner.h"

#include "model.h"

#include <stdio.h>

static void fill(void *look, uint16_t x0_px, uint16_t x1_px) { (void)look, (void)x0_px, (void)x1_px; }
static int show(void *ctx) { return ctx != NULL; }

int main(void)
{
    static uint32_t pixels[1];
    struct lim_target target = {.w_px = 128, .h_px = 64, .method = MODEL_SCENE_METHOD};

#if LIM_HAS_FRAMEBUFFER
    target.framebuffer = (struct lim_framebuffer){pixels, 128};
#elif LIM_HAS_FILL
    target.fill = fill;
    target.show = show;
#endif
    (void)fill, (void)show, (void)pixels;
    printf("%zu %zu\n", lim_mem_b(&model_scene, &target), (size_t)MODEL_SCENE_MEM_B(64));
    return 0;
}
END
asks_for() { # SCENE OPTION...: bytes into $work/asked
    scene=$1
    shift
    rm -f "$work"/model*
    "$BUILD/limner" compile "sim/scenes/$scene.obj" --size 128x64 -o "$work/model" "$@" >/dev/null &&
        scene_program "$work/asks" -DLIM_CONFIG='"model.h"' "$work/main.c" "$work"/model*.c && "$work/asks" >"$work/asked" && cat "$work/asked" &&
        awk '{ exit $1 != $2 || $1 <= 0 }' "$work/asked"
}
as_said() { # SCENE OPTION [OPTION...]: by lines, and less in a picture, which the first option asks for
    said_scene=$1 said_option=$2
    shift 2
    asks_for "$said_scene" "$@" && cp "$work/asked" "$work/by_lines" && asks_for "$said_scene" "$said_option" "$@" &&
        [ "$(cut -d ' ' -f 1 "$work/asked")" -lt "$(cut -d ' ' -f 1 "$work/by_lines")" ]
}
tap_check "rooms: memory as its header says, and less than for lines" as_said rooms --framebuffer
tap_check "so for a picture in pixels of the target's own" as_said rooms --fill
tap_check "a teapot: memory as its header says, and less than for lines" as_said teapot --framebuffer --tree clusters
tap_check "glass waits for its lines: the picture takes nothing off" asks_for glass --fill
tap_check "nor of a firmware that draws outlines as well" asks_for rooms --fill --wireframe

refuses() { # MESSAGE ARGUMENT...
    message=$1
    shift
    ! "$BUILD/limner" "$@" >"$work/out" 2>"$work/err" && cat "$work/err" && [ ! -s "$work/out" ] &&
        [ "$(wc -l <"$work/err")" -eq 1 ] && grep -qF -- "$message" "$work/err"
}
for option in --wireframe --antialias --delta; do
    tap_check "$option is refused" refuses "--framebuffer: $option is drawn line by line" \
        compile sim/scenes/rooms.obj --framebuffer $option --report
done
tap_check "glass is refused" refuses '--framebuffer: glass is drawn line by line' \
    compile sim/scenes/glass.obj --framebuffer --report
for command in 'compile --report' "measure --no-cost -o $work/moved"; do
    # shellcheck disable=SC2086 # a command and its options
    tap_check "${command%% *}: so are objects that move" refuses '--framebuffer: objects that move are drawn line by line' \
        $command sim/scenes/movers.gltf --framebuffer
done
tap_check "so are two pictures" refuses '--framebuffer --fill: the picture is kept once; take one of the two' \
    compile sim/scenes/rooms.obj --framebuffer --fill --report
for method in scanline newell depth; do
    tap_check "--method $method is refused" refuses "--framebuffer --method $method: it draws line by line; nearest and painter paint into one" \
        compile sim/scenes/rooms.obj --framebuffer --method $method --report
done
tap_check "--method convex is refused" refuses '--framebuffer --method convex: it draws line by line; nearest and painter paint into one' \
    compile sim/scenes/icosahedron.obj --framebuffer --method convex --report
tap_check "measure refuses as well" refuses '--framebuffer: --delta is drawn line by line' \
    measure sim/scenes/rooms.obj --framebuffer --delta --no-cost -o "$work/measured"
tap_done
