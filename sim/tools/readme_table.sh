# SPDX-License-Identifier: MIT
#
# For scripts to source that write one of README's tables, or of those that are too long for it: a table is what stands
# between the lines that say `NAME begin` and `NAME end`. readme_page NAME: the page that has it. readme_with NAME TABLE
# prints that page with the file TABLE in its place; readme_write NAME TABLE puts it there; readme_has NAME TABLE says
# how they differ.
# shellcheck shell=sh

readme_page() {
    grep -l "<!-- $1 begin" README.md sim/MEASURED.md tests/foreign/README.md || { echo "no page has a table $1" >&2; return 1; }
}

readme_with() {
    awk -v name="$1" -v table="$2" '
        $0 ~ "<!-- " name " end -->" { inside = 0 }
        !inside { print }
        $0 ~ "<!-- " name " begin" { inside = 1; while ((getline line < table) > 0) print line }' "$(readme_page "$1")"
}

readme_write() {
    readme_with "$1" "$2" >"$2.page" && cp "$2.page" "$(readme_page "$1")"
}

readme_has() {
    readme_with "$1" "$2" | diff "$(readme_page "$1")" -
}
