# SPDX-License-Identifier: MIT
#
# Delta output on the command line: whatever changes, and on whatever panel, the glass shows what it would show if every
# frame were sent whole; how much less is sent; the firmware's configuration; and what is refused.
. tests/tap.sh
. sim/scenes/cube.sh

few() { # FILE EVERY: some cameras of a file, each twice
    awk -v every="$2" '!/^#/ && NF && n++ % every == 0 { print; print }' "$1" | head -n 10 >"$work/few.cam"
}

same() { # MODEL OPTION...
    "$BUILD/limner" render "$@" --camera "$work/few.cam" --write-hashes "$work/whole" >/dev/null || return 1
    for delta in $memory; do
        "$BUILD/limner" render "$@" --camera "$work/few.cam" --check "$work/whole" $delta --stats >"$work/said" ||
            return 1
        tail -n 1 "$work/said"
    done
}

share() { # WORST% MODEL CAMERAS: of a whole frame's bytes, at most, on average
    "$BUILD/limner" render "$2" --camera "$3" --write-hashes "$work/whole" &&
        "$BUILD/limner" render "$2" --camera "$3" --check "$work/whole" --delta --stats >"$work/said" &&
        tail -n 1 "$work/said" && awk -v worst="$1" '/^delta: / { found = $2 + 0 > 0.5 && $2 + 0 <= worst } END { exit !found }' \
        "$work/said"
}

nothing_moves() {
    yes '0.42 1.6 0 1.416802 1.520085 0' | head -n 3 >"$work/few.cam"
    "$BUILD/limner" render sim/scenes/rooms.obj --camera "$work/few.cam" --delta --stats >"$work/said" &&
        grep '^delta: 0.00 %' "$work/said" && awk '/sent_px/ { on = 1 } on && $1 == "1" { exit $2 + $6 }' "$work/said"
}

compiled_knows_it() {
    "$BUILD/limner" compile sim/scenes/rooms.obj --size 96x72 --delta --round -o "$work/rooms" >/dev/null &&
        grep -q 'LIM_HAS_DELTA 1' "$work/rooms.h" && grep -q 'LIM_HAS_ROUND 1' "$work/rooms.h" &&
        runs=$(sed -n 's/^#define ROOMS_SCENE_DELTA_MEM_B(w_px, h_px) LIM_DELTA_MEM_B(w_px, h_px, \([0-9]*\)).*/\1/p' \
            "$work/rooms.h") && [ "$runs" -gt 500 ] && few sim/scenes/rooms.cam 8 &&
        "$BUILD/limner" render "$work/rooms.lim" --size 96x72 --camera "$work/few.cam" --delta="$runs" --stats >"$work/said" &&
        tail -n 1 "$work/said" && awk '/sent_px/ { on = 1 } on && $1 + 0 > 0 { whole += $5 } END { exit whole > 0 }' "$work/said"
}

others_do_not() {
    "$BUILD/limner" compile sim/scenes/rooms.obj --size 96x72 -o "$work/plain" >/dev/null &&
        grep -q 'LIM_HAS_DELTA 0' "$work/plain.h" && grep -q 'LIM_HAS_ROUND 0' "$work/plain.h" &&
        ! grep -q 'DELTA_MEM' "$work/plain.h"
}

refused() { # RUNS
    ! "$BUILD/limner" render sim/scenes/icosahedron.obj --delta="$1" >"$work/out" 2>"$work/said" &&
        [ "$(wc -l <"$work/said")" -eq 1 ] && grep -qE -e "^limner: --delta" "$work/said"
}

cube_make "$work"
tap_check "a cube that turns before a still camera: at most 6 % of the bytes" share 6 "$work/cube.dae" "$work/cube.cam"
tap_check "a walk: at most 10 %" share 10 sim/scenes/rooms.obj sim/scenes/rooms-walk.cam
tap_check "a turn: at most 12 %" share 12 sim/scenes/rooms.obj sim/scenes/rooms-turn.cam
tap_check "where nothing moves, nothing is sent" nothing_moves

memory=--delta
for scene in rooms rooms-tilted teapot knot glass; do
    cp "sim/scenes/$scene.cam" "$work/few.cam"
    tap_check "all of the $scene's path: the same" same "sim/scenes/$scene.obj" --size 120x120
done
cp sim/scenes/movers.cam "$work/few.cam"
tap_check "all of the movers' path: the same" same sim/scenes/movers.gltf --size 120x120
cp "$BUILD/scenes/textured/textured.cam" "$work/few.cam"
tap_check "all of the textured rooms' path: the same" same "$BUILD/scenes/textured/textured.obj" --size 120x120
cp "$BUILD/scenes/demo.cam" "$work/few.cam"
tap_check "all of the demo's path: the same" same "$BUILD/scenes/demo.obj"
memory='--delta --delta=150' # plenty, and too little

few sim/scenes/rooms-walk.cam 5
"$BUILD/limner" compile sim/scenes/rooms.obj -o "$work/rooms" >/dev/null
for panel in st7789 st7789:rgb444 ili9341:rgb666 gc9a01 ssd1351; do
    tap_check "the same on $panel" same "$work/rooms.lim" --size 101x77 --panel $panel
done
for panel in ssd1306 ssd1327 st7567; do
    tap_check "the same on $panel" same "$work/rooms.lim" --size 96x64 --panel $panel
done
tap_check "the same on glass that takes whole lines" same "$work/rooms.lim" --size 128x128 --panel ls013b7dh03
for method in painter depth newell clusters portals; do
    tap_check "the same by $method" same sim/scenes/rooms.obj --size 96x72 --method $method
done
tap_check "the same by the painter, who packs where he paints" \
    same sim/scenes/rooms.obj --size 95x72 --method painter --panel st7789:rgb444
tap_check "the same with smooth edges" same "$work/rooms.lim" --size 96x72 --antialias
tap_check "the same as wireframe" same sim/scenes/rooms.obj --size 96x72 --wireframe
few sim/scenes/rooms.cam 8
memory='--delta --delta=500 --delta=20 --delta=1'
tap_check "the same where the view jumps, with any memory" same "$work/rooms.lim" --size 120x90
memory='--delta --delta=150'
tap_check "the same of one convex solid" same sim/scenes/icosahedron.obj --size 96x72 --method convex
few sim/scenes/glass.cam 8
tap_check "the same through glass" same sim/scenes/glass.obj --size 96x72
few sim/scenes/movers.cam 1
tap_check "the same where things move" same sim/scenes/movers.gltf --size 96x72
few "$BUILD/scenes/textured/textured.cam" 8
tap_check "the same of textures, at rest and moving" same "$BUILD/scenes/textured/textured.obj" --size 96x72
tap_check "a compiled scene knows how much memory it takes" compiled_knows_it
tap_check "and others have nothing of it" others_do_not
for runs in 0 -3 70000 many; do
    tap_check "$runs runs are refused" refused $runs
done
tap_done
