# SPDX-License-Identifier: MIT
#
# The unit tests and a few frames under gcc's address and undefined-behaviour sanitizers: no report.
. tests/tap.sh

build=$BUILD/sanitize
# The longest tests do a part of their work here.
export TEST_EFFORT=5 ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1

make_all() {
    make -s BUILD="$build" OPT='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all' DEPS=skip \
        test-programs "$build/limner"
}

# A few frames of a scene by every method.
render() { # SCENE without suffix
    head -n 4 "$1.cam" >"$work/short.cam"
    for method in nearest scanline painter; do
        "$build/limner" render "$1.obj" --camera "$work/short.cam" --size 120x120 --method $method --stats \
            -o "$work/%03d.png" || return 1
    done
    "$build/limner" compile "$1.obj" -o "$work/scene"
}

tap_check "everything builds with the sanitizers" make_all
for program in "$build"/tests/test_*; do
    [ -x "$program" ] || continue
    tap_check "$(basename "$program")" "$program"
done
for scene in sim/scenes/rooms sim/scenes/rooms-tilted sim/scenes/teapot "$BUILD/scenes/demo"; do
    tap_check "frames of $(basename "$scene")" render "$scene"
done
tap_done
