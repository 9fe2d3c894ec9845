# SPDX-License-Identifier: MIT
#
# The unit tests under gcc's address and undefined-behaviour sanitizers: no report. sanitize_scenes.sh draws.
. tests/tap.sh

build=$BUILD/sanitize
# The longest tests do a part of their work here.
export TEST_EFFORT=5 ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1

make_all() {
    flock "$build.lock" make -s BUILD="$build" OPT='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all' DEPS=skip \
        test-programs "$build/limner"
}

tap_check "everything builds with the sanitizers" make_all
for program in "$build"/tests/test_*; do
    [ -x "$program" ] || continue
    tap_check "$(basename "$program")" "$program"
done
tap_done
