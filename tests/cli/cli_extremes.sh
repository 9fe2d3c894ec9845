# SPDX-License-Identifier: MIT
#
# Runs the tests of extremes, each for every precision profile, and compares tests/extremes/EXTREMES.md and its pictures with what
# they print and draw. `make extremes` (EXTREMES=write) writes both instead. All their frames take a minute and a half,
# which `make test SUITES=extremes` (EXTREMES=whole) spends; otherwise they draw a part of them: what is promised is
# asked of each frame all the same, but figures and pictures are of all frames, so of the page the promises alone are
# compared.
. tests/tap.sh

page=tests/extremes/EXTREMES.md pictures=tests/extremes/pictures
export EXTREMES_PICTURES="$work/pictures"
mkdir "$EXTREMES_PICTURES"
case ${EXTREMES:-} in
write | whole) compared=cat ;;
*) compared=promises TEST_EFFORT=10 && export TEST_EFFORT ;;
esac

# The page without what was measured.
promises() {
    sed 's/ | [^|]* |$/ |/'
}

holds() { # PROGRAM
    CMOCKA_MESSAGE_OUTPUT=TAP "$1" >"$work/output" 2>"$work/errors"
    status=$?
    cat "$work/output" >>"$work/rows"
    grep -v '^# extreme' "$work/output"
    cat "$work/errors"
    return $status
}

page_is_current() {
    sh tests/extremes/extremes.sh "$work/rows" "$EXTREMES_PICTURES" >"$work/page"
    [ "${EXTREMES:-}" != write ] || cp "$work/page" "$page"
    $compared <"$page" >"$work/kept_page" && $compared <"$work/page" | diff "$work/kept_page" -
}

# By their pixels: compressors differ.
hashes_of() { # FOLDER
    (cd "$1" && ls && { [ $compared = promises ] || "$limner" hashes ./*.png --write-hashes /dev/stdout; })
}

pictures_are_current() {
    limner=$(cd "$BUILD" && pwd)/limner
    if [ "${EXTREMES:-}" = write ]; then
        rm -rf "$pictures"
        cp -r "$EXTREMES_PICTURES" "$pictures"
    fi
    hashes_of "$pictures" >"$work/kept" && hashes_of "$EXTREMES_PICTURES" >"$work/drawn" &&
        diff "$work/kept" "$work/drawn"
}

for program in "$BUILD"/tests/test_extreme_*; do
    [ -x "$program" ] || continue
    tap_check "$(basename "$program")" holds "$program"
done
tap_check "$page says what was measured" page_is_current
tap_check "the page's pictures show what was drawn" pictures_are_current
tap_done
