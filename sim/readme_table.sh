# SPDX-License-Identifier: MIT
#
# For scripts to source that write one of README's tables: readme_with NAME TABLE prints README.md with the file TABLE
# between the lines that say `NAME begin` and `NAME end`; readme_write NAME TABLE puts it there.
# shellcheck shell=sh

readme_with() {
    awk -v name="$1" -v table="$2" '
        $0 ~ "<!-- " name " end -->" { inside = 0 }
        !inside { print }
        $0 ~ "<!-- " name " begin" { inside = 1; while ((getline line < table) > 0) print line }' README.md
}

readme_write() {
    readme_with "$1" "$2" >"$2.readme" && cp "$2.readme" README.md
}
