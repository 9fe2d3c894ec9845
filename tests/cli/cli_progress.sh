# SPDX-License-Identifier: MIT
#
# A first build says how many files it compiles, and about how long that takes: on a terminal [n/N] for each, elsewhere a line
# each half minute. Few files are compiled without numbers.
. tests/tap.sh

step() { # ARGUMENT...: on a pipe
    MAKE_TERMOUT='' sh sim/tools/progress.sh step "$work/bytes" "$@"
}

begins() {
    [ "$(sh sim/tools/progress.sh begin "$work/bytes" 600 | sed 's/about .* on [0-9]* /about T on P /')" = \
        '600 files to compile: about T on P processors' ]
}
counts() {
    sh sim/tools/progress.sh begin "$work/bytes" 2 >"$work/said"
    for name in a b c; do MAKE_TERMOUT=/dev/tty sh sim/tools/progress.sh step "$work/bytes" 2 "CC $name.c"; done >"$work/said"
    printf '%s\n' '[1/2] CC a.c' '[2/2] CC b.c' 'CC c.c' | diff - "$work/said"
}
keeps_quiet() { # the last one is told
    sh sim/tools/progress.sh begin "$work/bytes" 3 >"$work/said"
    { step 3 'CC a.c' && step 3 'CC b.c' && step 3 'CC c.c'; } >"$work/said" && echo '[3/3] files compiled' | diff - "$work/said"
}
tells() { # as if half a minute had passed
    sh sim/tools/progress.sh begin "$work/bytes" 3 >"$work/said"
    echo 1000 >"$work/bytes.told"
    { step 3 'CC a.c' && step 3 'CC b.c'; } >"$work/said" && echo '[1/3] files compiled' | diff - "$work/said"
}
few() { # nothing has begun, or nothing is to be numbered
    rm -f "$work/bytes"
    [ "$(step 7 'CC a.c')" = 'CC a.c' ] && [ -z "$(sh sim/tools/progress.sh begin "$work/bytes" 0)" ] &&
        [ ! -e "$work/bytes" ] && [ "$(step 0 'CC a.c')" = 'CC a.c' ]
}
numbered() { # what make would do in an empty folder
    make -n DEPS=skip BUILD="$work/empty" "$1" >"$work/would" 2>"$work/errors" || { cat "$work/errors" && return 1; }
    said=$(sed -n 's/.*progress.sh begin [^ ]* //p' "$work/would") && files=$(grep -c 'progress.sh step' "$work/would") &&
        echo "$said said, $files compiled" && [ "$said" -gt 500 ] && [ "$said" -eq "$files" ]
}
tap_check "how many files, and how long" begins
tap_check "on a terminal each is numbered; more than were missing are not" counts
tap_check "on a pipe they are not told one by one" keeps_quiet
tap_check "but each half minute" tells
tap_check "a few files have no numbers" few
tap_check "make all says as many as it compiles" numbered all
tap_check "make run says as many as it compiles" numbered run
tap_done
