# SPDX-License-Identifier: MIT
#
# What a script can see of the code's shape: layout by .clang-format, licence line and length of every
# file, nothing at the top level that does not belong there; and whether the pages' links lead somewhere.
. tests/tap.sh

folders='firmware hal boards sim tests'

formatted() {
    # shellcheck disable=SC2086 # folders are words
    find $folders -name '*.[ch]' -exec clang-format --dry-run -Werror {} +
}

licensed() {
    # shellcheck disable=SC2086
    ! find $folders Makefile .ci -type f \( -name '*.[ch]' -o -name '*.sh' -o -name '*.ld' -o -name '*.awk' \
        -o -name '*.mjs' -o -name '*.py' -o -name '*.S' -o -name '*.mk' \
        -o -name Makefile -o -name run \) -exec grep -L 'SPDX-License-Identifier: MIT' {} + | grep .
}

short() { # tests may be long: they are read one at a time
    find firmware hal boards sim -name '*.[ch]' -exec awk '
        FNR == 801 { print FILENAME " has more than 800 lines"; long = 1 }
        END { exit long }' {} +
}

tidy() {
    ! find . -maxdepth 1 -mindepth 1 -not -name '.*' -not -path "./${BUILD%%/*}" -not -name out |
        grep -vxE '\./(firmware|hal|boards|sim|tests|Makefile|README\.md|LICENSE|CHANGELOG\.md|CONTRIBUTING\.md)'
}

pages() {
    find $folders README.md CHANGELOG.md CONTRIBUTING.md -name '*.md' | LC_ALL=C sort
}

links_lead_somewhere() {
    pages >"$work/pages"
    xargs awk -f tests/links.awk <"$work/pages"
}

# Of these links four are broken, and each of them is named; what stands in code is none.
broken_links_are_named() {
    mkdir -p "$work/links/deep"
    printf '# Some `code`: a heading\n## Twice\n## Twice\n[a](deep/b.md#there) [b](#some-code-a-heading) [c](#twice-1)\n' >"$work/links/a.md"
    printf '[d](gone.md) [e](deep/b.md#gone)\n[f](#twice-2)\n    [g](code.md)\n`[h](code.md)`\n' >>"$work/links/a.md"
    printf '# There\n```\n# Not a heading\n[i](code.md)\n```\n[j](../a.md#twice) [k](../../gone)\n' >"$work/links/deep/b.md"
    awk -f tests/links.awk "$work/links/a.md" "$work/links/deep/b.md" >"$work/said" && return 1
    cat "$work/said"
    sed 's/^[^ ]*: \([^:]*\): .*/\1/' "$work/said" | tr '\n' ' ' >"$work/named"
    [ "$(cat "$work/named")" = 'gone.md deep/b.md#gone #twice-2 ../../gone ' ]
}

tap_check "every C file is laid out by clang-format (make format mends it)" formatted
tap_check "every source file names the licence" licensed
tap_check "no C file but a test is longer than 800 lines" short
tap_check "the top level holds nothing else" tidy
tap_check "the links of all pages lead to a file and to a heading that exist" links_lead_somewhere
tap_check "one that does not is named" broken_links_are_named
tap_done
