# SPDX-License-Identifier: MIT
# shellcheck shell=sh
#
# For tests/kernel.sh and sim/emulators/uml.sh: guests, which are runs of the tests' kernel, from what they need to what they said.
# Wants $work, a folder, $kernel, and $here, this folder.

# shellcheck disable=SC2154 # of who wants guests
stage=$work/stage

# What any guest needs, for any user to read; programs go to $stage/usual.
prepare_guests() {
    mkdir "$stage" "$stage/usual" && cp "$kernel" "$stage/kernel" &&
        cp tests/tap.sh "$here"/guest.sh "$here"/in_guest.sh "$here"/cases_*.sh "$stage" &&
        chmod 755 "$work" "$stage/guest.sh"
}

# Also a scene, and in $stage/usual the programs as they were built.
prepare_stage() {
    prepare_guests &&
        cp "$BUILD/limner" "$BUILD/tests/kernel/port_calls" "$stage/usual" &&
        cp "$BUILD/tests/kernel/power_off" "$BUILD/tests/kernel/bridge" "$here/pictures" "$stage" &&
        head -n 4 "$BUILD/scenes/demo.cam" >"$stage/demo.cam" &&
        "$BUILD/limner" compile "$BUILD/scenes/demo.obj" -o "$stage/demo" >"$work/compiled" &&
        chmod -R a+rX "$stage"
}

# As root a guest could write all of the host through its root file system.
as_nobody() {
    if [ "$(id -u)" = 0 ]; then
        setpriv --reuid=nobody --regid=nogroup --clear-groups --no-new-privs "$@"
    else
        "$@"
    fi
}

# guest NAME PROGRAMS CASES [VARIABLE=VALUE]...: what it writes goes to $stage/on-NAME, its console to
# $work/NAME.console, its status to $work/NAME.status. PROGRAMS is a folder in $stage.
guest() {
    name=$1 programs=$2 cases=$3 results=$stage/on-$1
    shift 3
    mkdir "$results"
    [ "$(id -u)" != 0 ] || chown nobody "$results"
    TMPDIR=$results HOME=$results as_nobody timeout -k 5 120 "$stage/kernel" mem=192M time-travel=inf-cpu quiet \
        con=null con0=null,fd:1 uml_dir="$results" root=/dev/root rootfstype=hostfs rootflags=/ ro \
        init="$stage/guest.sh" STAGE="$stage" RESULTS="$results" PROGRAMS="$programs" CASES="$cases" "$@" \
        </dev/null >"$work/$name.console" 2>&1
    echo $? >"$work/$name.status"
}

# Where processes may not be traced, or memory not be executed, the kernel ends before it has begun, and says so.
cannot_start() { # NAME
    [ "$(cat "$work/$1.status")" = 1 ] && [ ! -e "$stage/on-$1/guest.tap" ]
}

# It ran to its end, with a plan that it kept, something that passed and nothing that failed.
is_good() { # NAME
    tail -n 5 "$work/$1.console" "$stage/on-$1/guest.err"
    [ "$(cat "$work/$1.status")" = 0 ] && grep -q 'reboot: System halted' "$work/$1.console" && awk '
        /^ok /     { passed += !/# SKIP/; count++ }
        /^not ok / { failed++; count++ }
        /^1\.\./   { planned = substr($0, 4) }
        END        { exit !(passed && !failed && planned == count) }' "$stage/on-$1/guest.tap"
}

is_bad() { ! is_good "$1"; }

# What the guest said of its cases, as the script's own.
relay() { # NAME
    awk -v number="$tap_count" '
        /^1\.\./ { next }
        /^(not )?ok / { sub(/ok [0-9]+/, "ok " ++number) }
        { print }' "$stage/on-$1/guest.tap"
    tap_count=$((tap_count + $(grep -cE '^(not )?ok ' "$stage/on-$1/guest.tap")))
}
