# SPDX-License-Identifier: MIT
#
# Scenes and frames are the same bits whichever compiler built the program, optimised or not.
. tests/tap.sh

demo=$BUILD/scenes/demo
scenes="sim/scenes/rooms sim/scenes/teapot $demo"

# Builds in $BUILD/COMPILER-LEVEL, and sums up what the program makes of the scenes, file by file.
sums_of() { # COMPILER LEVEL
    build=$BUILD/$1$2
    make -s BUILD="$build" CC="$1" OPT="$2" DEPS=skip "$build/limner" || return 1
    for scene in $scenes; do
        out=$work/$1$2/$(basename "$scene")
        mkdir -p "$out"
        "$build/limner" compile "$scene.obj" -o "$out/scene" >/dev/null &&
            "$build/limner" render "$scene.obj" --camera "$scene.cam" --size 240x240 --ids "$out/ids" -o "$out/%03d.png" \
                >/dev/null || return 1
    done
    (cd "$work/$1$2" && find . -type f -exec sha256sum {} + | sort -k 2) >"$work/$1$2.sums"
    [ "$(grep -c png "$work/$1$2.sums")" -ge 3 ]
}

same_as_first() { # COMPILER LEVEL
    sums_of "$1" "$2" && diff "$work/gcc-O2.sums" "$work/$1$2.sums"
}

tap_check "gcc -O2 builds and renders" sums_of gcc -O2
tap_check "gcc -O0 gives the same scenes and frames" same_as_first gcc -O0
tap_check "clang -O2 gives the same scenes and frames" same_as_first clang -O2
tap_check "clang -O0 gives the same scenes and frames" same_as_first clang -O0
tap_done
