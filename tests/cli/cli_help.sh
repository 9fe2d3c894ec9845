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

# Goals, boards and suites that nearly are some.
says_of() { # PATTERN ARGUMENT...
    wanted=$1
    shift
    ! make -s DEPS=no "$@" >"$work/out" 2>"$work/said" && grep -q "$wanted" "$work/said" || { cat "$work/said" && return 1; }
}
make_asks_what_was_meant() {
    says_of 'there is no goal tset, is it test?; make help' tset && says_of 'there is no goal tests, is it test?;' tests &&
        says_of 'there is no goal nonsense; make help' nonsense && says_of 'there is no goal Veiw, is it view?' all Veiw &&
        says_of 'there is no suite hots, is it host?; there are: all host' test SUITES=hots &&
        says_of 'there is no suite nonsense; there are' test SUITES=nonsense &&
        says_of 'there is no board pcio, is it pico?; there are: .*bluepill' BOARD=pcio
}
board_in_any_case() { make -s -n DEPS=skip BOARD=PICO >"$work/out" 2>"$work/said" && ! grep -q 'no board' "$work/said" && ! grep -q 'boards/PICO' "$work/out"; }

# -- limner COMMAND --help ---------------------------------------------------------------------------------------------

limner=$(cd "$BUILD" && pwd)/limner
commands=$("$limner" help | sed -n 's/^ *limner \([a-z0-9-]*\)\( .*\)\{0,1\}$/\1/p' | sort -u)

# Arguments with which a command gets as far as its options, and writes nothing.
base_of() { # COMMAND
    case $1 in
    play) echo "--panel st7735 --spi $work/none --dc GPIO1 $work/none.obj" ;;
    module | card) echo "--panel st7735 -o $work/none/x.png" ;;
    decode) echo "--panel st7735 $work/none.log" ;;
    uf2 | boot2 | espimage) echo "$work/none.bin -o $work/none/x.c" ;;
    export) echo "--for plain -o $work/none --panel st7735 $work/none.obj" ;;
    bridge | devices | formats | hashes) ;;
    *) echo "$work/none.obj" ;;
    esac
}

answer() { # COMMAND OPTION [VALUE]: to that option, whatever it, or one that is nearly called so, is called
    # shellcheck disable=SC2046 # words
    (cd "$work/here" && "$limner" "$1" $(base_of "$1") "$2" ${3+"$3"} </dev/null 2>&1) |
        sed "s/$2/OPTION/g; s/, is it [^?]*?/;/; q"
}

# Both without and with a value an option that a command does not know is refused as one that no command knows.
knows() { # COMMAND OPTION
    [ "$(answer "$1" "$2")" != "$refusal" ] && [ "$(answer "$1" "$2" 1)" != "$refusal" ]
}

# The options that stand at the head of a line of help.
told() { # < HELP
    sed -n 's/^  -/-/p' | sed 's/  .*//' | grep -o -- '--[a-z][a-z-]*' | sort -u
}

helps() { # COMMAND
    "$limner" "$1" --help all >"$work/$1.help" 2>"$work/said" && [ ! -s "$work/said" ] &&
        grep -q "^usage: limner $1" "$work/$1.help" && sed '$!d' "$work/$1.help" | grep -q "^  limner $1" &&
        "$limner" help "$1" all | diff "$work/$1.help" - &&
        "$limner" "$1" --help >"$work/$1.short" && "$limner" help "$1" | diff "$work/$1.short" -
}

# A page at most; what is left out is named, and every line of it is one of the whole.
is_short() { # COMMAND
    [ "$(wc -l <"$work/$1.short")" -le 45 ] || { wc -l "$work/$1.short" && return 1; }
    ! grep -vxF -f "$work/$1.help" "$work/$1.short" | grep -v '^more options: limner .* --help all$' || return 1
    told <"$work/$1.help" >"$work/told" && told <"$work/$1.short" >"$work/told.short"
    if grep -q '^more options: ' "$work/$1.short"; then ! cmp -s "$work/told" "$work/told.short"; else diff "$work/told" "$work/told.short"; fi
}

render_begins_with_what_people_need() {
    grep -A 1 '^options:' "$work/render.short" | grep -q '^  -o PATTERN' &&
        for option in --gif --camera --size --panel --fov --precision --stats --compare; do
            told <"$work/render.short" | grep -qx -e "$option" || { echo "$option" && return 1; }
        done && ! grep -q -e --splitter "$work/render.short"
}

# What help tells is known, and what it does not tell is not, as far as the whole help has it.
tells_what_it_knows() { # COMMAND
    refusal=$(answer "$1" --nonsense)
    told <"$work/$1.help" >"$work/told"
    for option in $(cat "$work/options"); do
        case $1 in
        compile | render | view | measure | compare | splitters) ;;
        *) grep -qxe "$option" "$work/told" || continue ;; # what they do not know is in the way of what they miss
        esac
        if knows "$1" "$option"; then echo "$option"; fi
    done | diff "$work/told" -
}

everywhere_in_a_line() {
    "$limner" render none.obj --gif x.gif --help | diff "$work/render.short" - && ! "$limner" render -- --help >"$work/out" 2>&1
}

help_has_help() {
    for line in --help -h 'help --help'; do
        # shellcheck disable=SC2086 # words
        "$limner" $line | diff "$work/help" - || return 1
    done
}

names_the_unknown() {
    for line in 'nosuch --help' 'help nosuch'; do
        # shellcheck disable=SC2086 # words
        "$limner" $line >"$work/out" 2>"$work/said" && return 1
        [ ! -s "$work/out" ] && grep -qx "limner: no command 'nosuch'; .limner help. lists them" "$work/said" || return 1
    done
}

asks() { # PATTERN ARGUMENT...
    asked=$1
    shift
    ! "$limner" "$@" >"$work/out" 2>"$work/said" && [ ! -s "$work/out" ] && [ "$(wc -l <"$work/said")" -eq 1 ] &&
        grep -q "$asked" "$work/said"
}
asks_what_was_meant() {
    asks "no command 'rendr', is it render?" rendr house.obj && asks "no command 'complie', is it compile?" complie &&
        asks '^limner: --guf: no such option here, is it --gif?' render house.obj --guf x.gif &&
        asks '^limner: --presicion: no such option here, is it --precision?' compile house.obj --presicion=fast &&
        asks '^limner: --panel ST7798: no such panel, is it st7789?' render house.obj --panel ST7798 &&
        asks '^limner: --tree bps: no such tree, is it bsp?' compile house.obj --tree bps
}
values_are_no_options() { asks '^limner: none.obj: ' render none.obj --overlay --guf --stats; }

# The whole help has every option of every command.
whole_has_all() {
    for command in $commands; do told <"$work/$command.help"; done | sort -u | grep -vx -e --family -e --chip >"$work/each"
    "$limner" help | grep -o -- '--[a-z][a-z-]*' | sort -u >"$work/whole"
    ! grep -vxF -f "$work/whole" "$work/each"
}

tells_version() { "$BUILD/limner" --version | grep -Eqx 'limner [0-9]+\.[0-9]+\.[0-9]+'; }
tap_check "--version tells the version" tells_version
tap_check "make help begins with the six goals for newcomers" six_goals_come_first
tap_check "every goal is told once" goals_are_told_once
tap_check "a goal in no group is named" goal_without_group_is_named
tap_check "make names the nearest goal, suite or board" make_asks_what_was_meant
tap_check "a board is known in any capitals" board_in_any_case
tap_check "make flash without a board says which there are" board_is_asked_for
mkdir "$work/here" # files that options name
"$limner" help >"$work/help"
for command in help $commands; do "$limner" "$command" --help all; done | told >"$work/options"
for command in $commands; do
    tap_check "$command --help: usage, options, an example" helps "$command"
    tap_check "$command --help alone is a page" is_short "$command"
    tap_check "$command --help tells the options that it knows" tells_what_it_knows "$command"
done
tap_check "render --help begins with what people need" render_begins_with_what_people_need
tap_check "--help may stand behind other arguments, and before -- alone" everywhere_in_a_line
tap_check "help is told whichever way it is asked for" help_has_help
tap_check "help on no command is refused" names_the_unknown
tap_check "who mistypes a command, an option or a name is asked for the nearest" asks_what_was_meant
tap_check "what is an option's value is not taken for an option" values_are_no_options
tap_check "limner help has the options of all commands" whole_has_all
tap_done
