# SPDX-License-Identifier: MIT
#
# Sourced by the tests of refusals. Files go to $work/out, if the command names them there.

refused() { # PATTERN ARGUMENT...: one line, exit status 1, no file. Lines that match $ignored are not counted
    pattern=$1
    shift
    rm -rf "$work/out"
    mkdir "$work/out"
    timeout 60 "$limner" "$@" >"$work/said" 2>"$work/err" </dev/null
    status=$?
    cat "$work/err"
    [ $status -eq 1 ] && [ ! -s "$work/said" ] && [ "$(grep -vc -- "${ignored:-a^}" "$work/err")" -eq 1 ] &&
        [ -z "$(find "$work/out" -type f)" ] && grep -qE -- "$pattern" "$work/err"
}
