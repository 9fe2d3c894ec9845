# SPDX-License-Identifier: MIT
#
# What a newcomer is told: `make help`, and the options of each command.
. tests/tap.sh

goals_of() { # GROUP'S-TITLE: of what make help says
    awk -v title="$1" 'index($0, title) == 1 { inside = 1; next } /^$/ { inside = 0 } inside { print $2 }' "$work/goals"
}

six_goals_come_first() {
    make -s help >"$work/goals" && head -n 1 "$work/goals" | grep -q '^To begin with' &&
        [ "$(goals_of 'To begin with' | tr '\n' ' ')" = 'all run view test flash emulate ' ]
}

# Whatever the Makefiles say of a goal is told once, in one of the groups.
goals_are_told_once() {
    sed -n 's/^\([a-z0-9-]*\):.* ## .*/\1/p' Makefile boards/image.mk | sort >"$work/there"
    sed -n 's/^  make \([a-z0-9-]*\) .*/\1/p' "$work/goals" | sort >"$work/told"
    [ "$(wc -l <"$work/told")" -gt 30 ] && diff "$work/there" "$work/told"
}

goal_without_group_is_named() {
    printf 'first: ## [start] is in a group\nother: first ## is in none\n' >"$work/Makefile"
    ! awk -f sim/tools/help.awk "$work/Makefile" 2>"$work/said" >/dev/null && grep -q '^make help: other is in no group' "$work/said"
}

# Goals of images say that they want a board, and which there are.
board_is_asked_for() {
    for goal in flash emulate cost rules; do
        make -s DEPS=no "$goal" >/dev/null 2>"$work/said" && return 1
        grep -q "$goal: say BOARD=NAME; there are:.* pico" "$work/said" || return 1
    done
}

tap_check "make help begins with the six goals for newcomers" six_goals_come_first
tap_check "every goal is told once" goals_are_told_once
tap_check "a goal in no group is named" goal_without_group_is_named
tap_check "make flash without a board says which there are" board_is_asked_for
tap_done
