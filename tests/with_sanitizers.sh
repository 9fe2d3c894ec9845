# SPDX-License-Identifier: MIT
#
# For test scripts to source: sanitized GOAL... builds with gcc's address and undefined-behaviour sanitizers, in $build,
# which several scripts share. A report ends a program.
# shellcheck shell=sh

build=$BUILD/sanitize
. tests/part_of.sh
export ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1

# Lines and functions are enough for a report, at two thirds of the size. No object has the folder's name in it, so that
# a cache of objects serves the next clone as well.
sanitized() {
    mkdir -p "$build"
    flock "$build.lock" make -s BUILD="$build" DEPS=skip \
        OPT="-O1 -g1 -fdebug-prefix-map=$PWD=. -DLIM_DEBUG_ASSERT=LIM_ASSERT -fsanitize=address,undefined \
            -fno-sanitize-recover=all" "$@"
}
