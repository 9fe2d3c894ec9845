# SPDX-License-Identifier: MIT
#
# The tables that are measured and written into pages. Each stands between two lines of one page, `<!-- NAME begin: make GOAL -->`
# and `<!-- NAME end -->`. In the project's folder:
#   sh sim/tools/tables.sh [NAME...]            measures tables and prints them
#   sh sim/tools/tables.sh --write [NAME...]    writes them into their pages, and the pictures beside them into sim/scenes
#   sh sim/tools/tables.sh --check [NAME...]    says how the pages differ, with exit status 1; NAME:PART: what of a slow table
#                                               is quick to measure, as tradeoff:rooms
#   sh sim/tools/tables.sh --show NAME          prints what stands in the page
#   sh sim/tools/tables.sh --list               name, speed and goal of all tables
# Without a name: all that are quick. A table that fails leaves its page as it was.
#
# Another table is a line of list() and a file sim/tools/tables/FILE.sh, which is run by `sh -eu` with the table's name and
# prints its rows. $work is a folder for its files; $pictures, empty but for --write, one for pictures of sim/scenes. With
# `NAME part PART` the file prints what of that part is quick to measure; with `NAME of PART`, what a table has of it.
set -eu

: "${BUILD:=build}"
export BUILD

# Name, speed, make's goal, file, and what it needs: commands, and /FILES of $BUILD. The TABLES of `tables` are the quick ones.
list() {
    cat <<'END'
accuracy quick tables accuracy /limner /scenes/demo.obj
bridge quick tables bridge /limner
delta quick tables delta /limner
formats quick tables formats /limner
figures quick bench-baseline bench
peers quick bench-baseline bench
bench quick bench-baseline bench
bench-stages quick bench-baseline bench
bench-memory quick bench-baseline bench
flags slow tables-flags flags /limner arm-none-eabi-gcc avr-gcc
footprint slow footprint footprint /limner /scenes/demo.obj arm-none-eabi-gcc
tradeoff slow tradeoff tradeoff /limner /scenes/demo.obj gnuplot
compare slow compare compare /limner
methods slow tables-methods methods /limner /generate_bench arm-none-eabi-gcc qemu-system-arm
scale slow scale scale /limner /generate_scale arm-none-eabi-gcc qemu-system-arm gnuplot
predictions slow predictions predictions /limner /generate_scale /scenes/demo.obj
along slow predictions along /limner
levels slow tables-levels levels /limner arm-none-eabi-gcc qemu-system-arm
level-walks slow tables-level-walks level_walks /limner arm-none-eabi-gcc qemu-system-arm
doom slow tables-doom doom /limner apt-get valgrind
visibility slow tables-visibility visibility /limner
delta-cost slow tables-delta-cost delta /limner arm-none-eabi-gcc qemu-system-arm
overlay-cost slow tables-overlay-cost overlay /limner arm-none-eabi-gcc qemu-system-arm
texels slow tables-texels texels /limner arm-none-eabi-gcc qemu-system-arm
walk-cost slow tables-walk-cost walks /limner /scenes/demo.obj arm-none-eabi-gcc qemu-system-arm
boards slow tables-boards boards /limner
foreign slow tables-foreign foreign /limner
END
}

fail() {
    echo "tables.sh: $*" >&2
    return 1
}

field() { # TABLE COLUMN
    list | awk -v name="$1" -v column="$2" '$1 == name { print $column; found = 1 } END { exit !found }'
}

# What stands for `make GOAL` in a page: tables-NAME is `make tables TABLES=NAME`.
goal() { # TABLE
    field "$1" 3 | sed 's/^tables-/tables TABLES=/; s/^/make /'
}

# -- Pages -------------------------------------------------------------------------------------------------------------

# The one page that has the table between two lines in that order.
page_of() { # TABLE
    # shellcheck disable=SC2046 # a page is a word
    set -- "$1" $(find README.md boards firmware hal sim tests -name '*.md' -exec grep -l "<!-- $1 begin" {} + 2>/dev/null)
    [ $# -eq 2 ] || { fail "$1: $(($# - 1)) pages have that table, it takes one"; return 1; }
    [ "$(grep -o "<!-- $1 \(begin\|end\)" "$2" | sed 's/.* //' | tr '\n' ' ')" = 'begin end ' ] ||
        { fail "$1: $2 has no line for its begin and behind it one for its end"; return 1; }
    echo "$2"
}

table_of() { # TABLE PAGE
    awk -v name="$1" '
        $0 ~ "<!-- " name " end" { inside = 0 }
        inside { print }
        $0 ~ "<!-- " name " begin" { inside = 1 }' "$2"
}

page_with() { # TABLE FILE PAGE: the page with the file in the table's place
    awk -v name="$1" -v file="$2" '
        $0 ~ "<!-- " name " end" { inside = 0 }
        !inside { print }
        $0 ~ "<!-- " name " begin" { inside = 1; while ((getline line < file) > 0) print line }' "$3"
}

# -- Measuring ---------------------------------------------------------------------------------------------------------

check_needs() { # TABLE
    for need in $(list | sed -n "s/^$1 [^ ]* [^ ]* [^ ]* *//p"); do
        case $need in
        /*) [ -e "$BUILD$need" ] || fail "$1: there is no $BUILD$need; try \`$(goal "$1")\`" || return 1 ;;
        *) command -v "$need" >/dev/null || fail "$1: there is no $need; \`$(goal "$1")\` installs it" || return 1 ;;
        esac
    done
}

# Its own process, in which set -e holds.
run() { # TABLE [part PART|of PART]
    sh -eu "sim/tools/tables/$(field "$1" 4).sh" "$@"
}

# A figure that could not be measured leaves an empty cell, or none.
check_rows() { # TABLE FILE
    why=$(awk -F '|' '
        /^\|/ && !head { head = NF; next }
        /^\| *-+/ { next }
        /^\|/ && (NF != head || /\| *\|/) { print "a figure is missing: " $0; bad = 1; exit }
        /^\|/ { rows++ }
        END { if (!rows && !bad) print "there are no rows" }' "$2")
    [ -z "$why" ] || fail "$1: $why"
}

measure() { # TABLE FILE
    rm -rf "$all/work" && mkdir "$all/work"
    check_needs "$1" || return 1
    run "$1" >"$2" || fail "$1: cannot be measured, $(page_of "$1") stays as it is" || return 1
    check_rows "$1" "$2"
}

# -- What is asked for -------------------------------------------------------------------------------------------------

print() { # TABLE
    measure "$1" "$all/table" && cat "$all/table"
}

# One at a time, for make may run several of these scripts at once.
replace() { # TABLE PAGE
    (
        flock 9
        page_with "$1" "$all/table" "$2" >"$all/page" && cp "$all/page" "$2.new" && mv "$2.new" "$2"
    ) 9<sim/tools/tables.sh
}

write() { # TABLE
    page=$(page_of "$1") || return 1
    pictures=$all/pictures
    rm -rf "$pictures" && mkdir "$pictures"
    measure "$1" "$all/table" && replace "$1" "$page" || return 1
    echo "$1: $page"
    find "$pictures" -type f -exec mv {} sim/scenes/ \;
}

check() { # TABLE[:PART]
    name=${1%%:*} part=${1#"$name"}
    part=${part#:}
    page=$(page_of "$name") || return 1
    if [ -z "$part" ]; then
        measure "$name" "$all/table" && page_with "$name" "$all/table" "$page" | diff "$page" -
        return
    fi
    mkdir -p "$all/work"
    run "$name" part "$part" >"$all/now" && table_of "$name" "$page" >"$all/table" &&
        run "$name" of "$part" <"$all/table" >"$all/before" || fail "$1: cannot be measured" || return 1
    [ -s "$all/now" ] || fail "$1: there is no such part" || return 1
    diff "$all/before" "$all/now"
}

show() { # TABLE
    page=$(page_of "$1") && table_of "$1" "$page"
}

action=print
case ${1:-} in
--write | --check | --show) action=${1#--} && shift ;;
--list) list | cut -d ' ' -f 1-2 | while read -r name speed; do echo "$name $speed $(goal "$name")"; done && exit ;;
-*) fail "$1: there are --write, --check, --show and --list" || exit 1 ;;
esac

for name; do
    field "${name%%:*}" 1 >/dev/null || fail "$name: no such table; there are $(list | awk '{ printf "%s%s", n++ ? " " : "", $1 }')" || exit 1
    case $action$name in *:*) [ "$action" = check ] || fail "$name: parts are for --check" || exit 1 ;; esac
done
# shellcheck disable=SC2046 # names are words
[ $# -gt 0 ] || set -- $(list | awk '$2 == "quick" { print $1 }')

pictures=
all=$(mktemp -d)
work=$all/work
export work pictures
trap 'rm -rf "$all"' EXIT
trap 'exit 1' INT TERM HUP
failed=0
for name; do
    "$action" "$name" || failed=1
done
exit $failed
