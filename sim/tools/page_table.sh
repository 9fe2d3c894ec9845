# SPDX-License-Identifier: MIT
#
# For scripts to source that write a table into the page that has it: a table is what stands between the lines that say
# `NAME begin` and `NAME end`, in exactly one page. page_of NAME: that page. page_table NAME: the table as it stands there.
# page_with NAME TABLE prints the page with the file TABLE in its place; page_write NAME TABLE puts it there; page_has
# NAME TABLE says how they differ.
# shellcheck shell=sh

page_of() {
    # shellcheck disable=SC2046 # a page is a word
    set -- "$1" $(grep -rl --include='*.md' "<!-- $1 begin" README.md boards firmware hal sim tests)
    [ $# -eq 2 ] || { echo "$(($# - 1)) pages have a table $1" >&2; return 1; }
    echo "$2"
}

page_table() {
    sed -n "/<!-- $1 begin/,/<!-- $1 end/p" "$(page_of "$1")" | sed '1d; $d'
}

page_with() {
    awk -v name="$1" -v table="$2" '
        $0 ~ "<!-- " name " end -->" { inside = 0 }
        !inside { print }
        $0 ~ "<!-- " name " begin" { inside = 1; while ((getline line < table) > 0) print line }' "$(page_of "$1")"
}

page_write() {
    page_with "$1" "$2" >"$2.page" && cp "$2.page" "$(page_of "$1")"
}

page_has() {
    page_with "$1" "$2" | diff "$(page_of "$1")" -
}
