# SPDX-License-Identifier: MIT
#
# For test scripts to source: one_file prints the name of a file that is all of firmware/, which compiles in a third of the
# time that its files take (no two statics there have one name: cross.sh). It lies where a compiler's cache finds it again.
# What tests how users build compiles file by file.
# shellcheck shell=sh

one_file() {
    mkdir -p "$kept"
    # shellcheck disable=SC2046 # names are words
    printf '#include "%s"\n' $(cd firmware && echo *.c */*.c) >"$kept/firmware.c.$$" &&
        mv "$kept/firmware.c.$$" "$kept/firmware.c" && echo "$kept/firmware.c"
}
