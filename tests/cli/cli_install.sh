# SPDX-License-Identifier: MIT
#
# make install and make uninstall, into a folder of the test's: the program works from there without its sources, the manual
# page is free of warnings and names what the help names, bash completes from the installed script, and whoever uninstalls
# finds what was there before, and nothing else.
. tests/tap.sh

root="$work/a root"
prefix="/opt/some where"
there=$root$prefix

installed() { # GOAL [PREFIX]
    make -s DEPS=skip BUILD="$BUILD" PREFIX="${2-$prefix}" DESTDIR="$root" "$1" >"$work/said" 2>&1 || { cat "$work/said" && return 1; }
}
files() { (cd "$root" && find . | LC_ALL=C sort); }

# -- What is there before: a folder with somebody else's file ---------------------------------------------------------
mkdir -p "$there/share/man/man1" "$there/bin"
echo theirs >"$there/bin/other"
files >"$work/before"

list() {
    installed install && (cd "$there" && find . -type f | LC_ALL=C sort) >"$work/list" && cat "$work/list" &&
        printf './%s\n' bin/limner bin/other share/bash-completion/completions/limner share/doc/limner/CHANGELOG.md \
            share/doc/limner/LICENSE share/doc/limner/README.md share/limner/installed share/man/man1/limner.1 | diff - "$work/list"
}
tap_check "it installs eight things, in folders with blanks" list

# From another folder, found by PATH, with nothing else in the environment.
from_there() { env -i PATH="$there/bin:/usr/bin:/bin" limner "$@"; }
works() {
    cp sim/scenes/icosahedron.obj "$work/files/" && cmp "$there/bin/limner" "$BUILD/limner" && cd "$work/files" &&
        from_there render icosahedron.obj --size 32x32 -o one.png && [ -s one.png ] &&
        from_there compile icosahedron.obj -o solid >/dev/null && [ -s solid.c ] && rm icosahedron.obj one.png solid.*
}
mkdir "$work/files"
tap_check "the program draws and compiles from there" works

# As other packages spell it.
small_letters() {
    make -s DEPS=skip BUILD="$BUILD" prefix=/usr DESTDIR="$work/small" install >"$work/said" 2>&1 && [ -x "$work/small/usr/bin/limner" ] &&
        make -s DEPS=skip BUILD="$BUILD" prefix=/usr DESTDIR="$work/small" uninstall >"$work/said" 2>&1 && [ ! -e "$work/small/usr/bin/limner" ]
}
tap_check "prefix= is PREFIX=" small_letters

# -- The manual page ---------------------------------------------------------------------------------------------------
page=$there/share/man/man1/limner.1
if command -v groff >/dev/null; then
    lints() { groff -ww -man -Tutf8 "$page" >"$work/page" 2>"$work/warnings" && cat "$work/warnings" && [ ! -s "$work/warnings" ]; }
    tap_check "groff has no warning for the manual page" lints
    # Whatever the help of all commands names as an option or a command is in the page as it is shown.
    names_all() {
        groff -man -Tascii -P-c -P-b -P-u "$page" | tr -s ' \n' '\n\n' >"$work/words" &&
            "$BUILD/limner" help | grep -oE -e '--[a-z][a-z-]*' | sort -u >"$work/options" && [ "$(wc -l <"$work/options")" -gt 60 ] &&
            while read -r option; do grep -qF -e "$option" "$work/words" || { echo "$option is missing" && return 1; }; done <"$work/options"
    }
    tap_check "it names all options of the help" names_all
else
    tap_skip "the manual page" "groff is not installed"
fi

# -- Completion --------------------------------------------------------------------------------------------------------
# completes WANTED WORD...: what the last word becomes, on one line.
completes() {
    wanted=$1
    shift
    cat >"$work/complete.bash" <<'EOF'
. "$1"
shift
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_limner
echo "${COMPREPLY[*]}"
EOF
    said=$(cd "$work/files" && bash "$work/complete.bash" "$there/share/bash-completion/completions/limner" "$@") && echo "$said" && [ "$said" = "$wanted" ]
}
: >"$work/files/house.obj"
: >"$work/files/hut with a door.obj"
tap_check "a command" completes 'render report-bug replay report' limner re
tap_check "its help" completes 'splitters' limner help sp
tap_check "an option of a command" completes '--max-error --max-vertex-error' limner compile --max
tap_check "which another command has not" completes '' limner hashes --max
tap_check "options of several on a line" completes '--mirror --mirror-columns --mirror-rows' limner module --mirror
tap_check "a panel" completes 'ssd1306 ssd0323 ssd1327 ssd1351' limner play --panel ssd
tap_check "memory, where it is one" completes 'memory' limner render --panel me
tap_check "but not elsewhere" completes '' limner module --panel me
tap_check "a method" completes 'painter portals' limner render --method p
tap_check "a profile" completes 'draft fast fine exact' limner compile --precision ''
tap_check "a processor" completes 'm0plus m3 m4 m33 rv32' limner compile --core ''
tap_check "what code is for" completes 'speed balance size' limner measure --optimise ''
tap_check "where to export to" completes 'arduino idf pico cmake plain' limner export --for ''
tap_check "a boot drive's processor" completes 'rp2040 rp2350-arm-s' limner uf2 --family rp
tap_check "a chip of Espressif's" completes 'esp32c3' limner espimage --chip ''
tap_check "a light" completes 'baked turning' limner render --mover-light ''
tap_check "whether things move" completes 'on off' limner render --movers ''
tap_check "whether there are portals" completes 'on off auto' limner compile --portals ''
tap_check "an axis" completes 'y z' limner render --up ''
tap_check "doors" completes 'closed open move' limner view --doors ''
tap_check "a file" completes 'house.obj hut with a door.obj' limner render h
tap_check "a file after an option" completes 'house.obj' limner render x.obj --camera ho
options_agree() { # each option that completion offers is in that command's help
    "$BUILD/limner" help --bash-completion | sed -n "s/^ *\([a-z0-9-]*\)) words=' \(-.*\)' ;;\$/\1 \2/p" >"$work/offers"
    [ "$(wc -l <"$work/offers")" -ge 17 ] && while read -r command options; do
        "$BUILD/limner" "$command" --help all >"$work/help"
        for option in $options; do
            [ "$option" = --help ] || grep -q -e "^  .*$option" "$work/help" || { echo "$command: $option" && return 1; }
        done
    done <"$work/offers"
}
tap_check "all that it offers is in the command's help" options_agree

# -- Away again --------------------------------------------------------------------------------------------------------
again() { # what an older version has put there is replaced
    echo "f $prefix/share/doc/limner/OLD" >>"$there/share/limner/installed" && : >"$there/share/doc/limner/OLD" &&
        installed install && [ ! -e "$there/share/doc/limner/OLD" ] && [ -x "$there/bin/limner" ]
}
tap_check "installing again leaves nothing of what was" again

# Whatever fails, and after however many files: what was there is there still.
state() { files && (cd "$root" && find . -type f -exec sha256sum {} + | LC_ALL=C sort); }
fails() { # [PREFIX]
    state >"$work/there" && ! installed install "$@" && state | diff "$work/there" -
}
full() { # for a file past 50 KB: the program
    (trap '' XFSZ && export LC_ALL=C && ulimit -f 100 && fails) && cat "$work/said" && grep -q 'File too large' "$work/said"
}
tap_check "a disk that is full leaves the older version" full
folder_in_the_way() { # of the last file
    license=$there/share/doc/limner/LICENSE
    rm "$license" && mkdir "$license" && fails && rmdir "$license" && grep -qx "install: $license: is a folder" "$work/said"
}
tap_check "so does a folder where a file is to be" folder_in_the_way
file_in_the_way() { # of a folder, where nothing is installed
    mkdir -p "$root/other/share" && echo theirs >"$root/other/share/doc" && fails /other && rm -r "$root/other"
}
tap_check "a file where a folder is to be leaves nothing" file_in_the_way

away() { installed uninstall && files | diff "$work/before" -; }
tap_check "uninstalling leaves what was there before" away
twice() { ! installed uninstall >/dev/null && grep -q 'is not installed there' "$work/said" && files | diff "$work/before" -; }
tap_check "and is refused where nothing is installed" twice
kept() { # a file of somebody's in a folder of ours
    installed install && echo theirs >"$there/share/doc/limner/notes" && installed uninstall &&
        [ "$(cat "$there/share/doc/limner/notes")" = theirs ] && [ ! -e "$there/share/doc/limner/README.md" ] && rm -r "$there/share/doc/limner"
}
tap_check "somebody's file in a folder of ours stays" kept
relative() { ! installed install here >/dev/null && grep -q 'PREFIX=here: must be an absolute path' "$work/said" && [ ! -e here ]; }
tap_check "a relative PREFIX is refused" relative
tap_done
