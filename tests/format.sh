# SPDX-License-Identifier: MIT
#
# What a script can see of the code's shape: layout by .clang-format, licence line and length of every
# file, nothing at the top level that does not belong there.
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
        FNR == 501 { print FILENAME " has more than 500 lines"; long = 1 }
        END { exit long }' {} +
}

tidy() {
    ! find . -maxdepth 1 -mindepth 1 -not -name '.*' -not -path "./${BUILD%%/*}" -not -name out |
        grep -vxE '\./(firmware|hal|boards|sim|tests|Makefile|README\.md|LICENSE|CHANGELOG\.md|CONTRIBUTING\.md)'
}

tap_check "every C file is laid out by clang-format (make format mends it)" formatted
tap_check "every source file names the licence" licensed
tap_check "no C file but a test is longer than 500 lines" short
tap_check "the top level holds nothing else" tidy
tap_done
