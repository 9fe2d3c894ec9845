# SPDX-License-Identifier: MIT
#
# Scenes and frames are the same bits whichever compiler built the program, optimised or not: clang, and both without
# optimisation take turns, a build in each run (tests/part_of.sh).
. tests/tap.sh
. tests/part_of.sh

demo=$BUILD/scenes/demo
scenes="sim/scenes/rooms sim/scenes/teapot $demo"

# A third of each path: what is not optimised takes its time.
for scene in $scenes; do
    awk '!/^#/ && NF && n++ % 3 == 0' "$scene.cam" >"$work/$(basename "$scene").cam"
done

# How the largest is drawn is said, as finding that out takes its time, too; for the others it is found out.
options_of() { # SCENE
    [ "$1" != "$demo" ] || echo '--tree bsp --portals off --mesh-leaves none'
}

# Sums up what a program makes of the scenes, file by file.
sums_of() { # NAME PROGRAM
    for scene in $scenes; do
        out=$work/$1/$(basename "$scene")
        mkdir -p "$out"
        # shellcheck disable=SC2046 # options are words
        "$2" compile "$scene.obj" $(options_of "$scene") -o "$out/scene" >/dev/null &&
            "$2" render "$scene.obj" $(options_of "$scene") --camera "$work/$(basename "$scene").cam" --size 240x240 --ids "$out/ids" \
                -o "$out/%03d.png" >/dev/null || return 1
    done
    (cd "$work/$1" && find . -type f -exec sha256sum {} + | sort -k 2) >"$work/$1.sums"
    [ "$(grep -c png "$work/$1.sums")" -ge 3 ]
}

# Builds in $BUILD/COMPILER-LEVEL.
same_as_first() { # COMPILER LEVEL
    make -s BUILD="$BUILD/$1$2" CC="$1" OPT="$2" DEPS=skip "$BUILD/$1$2/limner" && sums_of "$1$2" "$BUILD/$1$2/limner" &&
        diff "$work/first.sums" "$work/$1$2.sums"
}

tap_check "the program that all other tests run renders" sums_of first "$BUILD/limner"
echo "# SEED=$SEED"
for build in $(part_of 3 clang-O2 gcc-O0 clang-O0); do
    tap_check "${build%-*} -${build#*-} gives the same scenes and frames" same_as_first "${build%-*}" "-${build#*-}"
done
tap_done
