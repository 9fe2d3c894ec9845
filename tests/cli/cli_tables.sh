# SPDX-License-Identifier: MIT
#
# Tables in pages: they say what the program measures, and the script that writes them leaves a page as it was when a table
# cannot be measured.
. tests/tap.sh

tables=$PWD/sim/tools/tables.sh

# -- The project's pages --------------------------------------------------------------------------------------------------

# Lines "NAME GOAL" of the pages' markers, and of the list.
markers() {
    find README.md CONTRIBUTING.md boards firmware hal sim tests -name '*.md' -exec sed -n 's/^<!-- \([^ ]*\) begin: \(.*\) -->$/\1 \2/p' {} + | sort
}

every_table_has_its_place() {
    markers >"$work/markers"
    sh "$tables" --list | sed 's/ [a-z]* / /' | sort | diff - "$work/markers" && [ "$(wc -l <"$work/markers")" -gt 10 ]
}

# No marker in another form than the one that is looked for.
no_other_marker() {
    [ "$(find . -path "./${BUILD%%/*}" -prune -o -name '*.md' -exec grep -h '<!-- .* begin' {} + | wc -l)" -eq "$(wc -l <"$work/markers")" ]
}

goals_exist() {
    sh "$tables" --list | while read -r name speed words; do
        goal=${words#make }
        make -n DEPS=skip BUILD="$BUILD" $goal >"$work/said" 2>&1 || { cat "$work/said"; exit 1; }
        case $goal in
        bench-baseline) ;;
        tables) [ "$speed" = quick ] && grep -q 'tables.sh --write *$' "$work/said" ;;
        *) grep -qx "sh sim/tools/tables.sh --write $name" "$work/said" ;;
        esac || { echo "$goal does not write $name"; exit 1; }
    done
}

tap_check "every table of the list stands in a page, which names the goal that writes it" every_table_has_its_place
tap_check "and no other table does" no_other_marker
tap_check "these goals are make's, and write it" goals_exist
tap_check "accuracy is what is measured now" sh "$tables" --check accuracy
tap_check "so is what delta output sends to an SSD1306" sh "$tables" --check delta:ssd1306
tap_check "so is what is read of each format" sh "$tables" --check formats

# -- A project of its own, whose one table is made by the lines of a script -----------------------------------------------

own=$work/own
mkdir -p "$own/sim/tools/tables" "$own/sim/scenes" "$own/build/scenes"
cp "$tables" "$own/sim/tools"
touch "$own/build/limner"

page() { printf 'Before.\n<!-- bridge begin: make tables -->\n| old |\n|---|\n| 1 |\n<!-- bridge end -->\nAfter.\n'; }

afresh() { page >"$own/README.md" && cp "$own/README.md" "$own/kept"; }

# run OPTION...: what it says in $work/said and $work/err.
run() { (cd "$own" && BUILD=build sh sim/tools/tables.sh "$@") >"$work/said" 2>"$work/err"; }

prints() { cat >"$own/sim/tools/tables/bridge.sh"; }

untouched() { diff "$own/kept" "$own/README.md" && [ -z "$(find "$own" -name '*.new')" ]; }

# says PATTERN OPTION...: fails with one such line, and the page is as it was.
says() {
    pattern=$1
    shift
    ! run "$@" && cat "$work/err" && [ "$(grep -c '^tables.sh: ' "$work/err")" -eq 1 ] && grep -q -- "$pattern" "$work/err" &&
        untouched
}

fails() { # PATTERN: as does the script on stdin
    prints && afresh && says "$1" --write bridge
}

writes_its_table_alone() {
    prints <<'END'
echo '| new |'
echo '|---|'
echo '| 2 |'
END
    afresh && run --write bridge && page | sed 's/old/new/; s/| 1 |/| 2 |/' | diff - "$own/README.md" &&
        run --check bridge && run --show bridge && [ "$(wc -l <"$work/said")" -eq 3 ]
}

tells_a_difference() {
    afresh && ! run --check bridge && grep -q '| 2 |' "$work/said" && untouched && run bridge && grep -q '| 2 |' "$work/said" && untouched
}

pictures_come_with_it() {
    prints <<'END'
printf '| new |\n|---|\n| 2 |\n'
[ -z "$pictures" ] || echo drawn >"$pictures/bridge.png"
END
    afresh && run --check bridge
    [ ! -e "$own/sim/scenes/bridge.png" ] && run --write bridge && grep -q drawn "$own/sim/scenes/bridge.png"
}

ends_in_the_middle() {
    fails 'cannot be measured' <<'END'
echo '| new |'
false
echo '|---|'
END
}

# The reason is its own program's, and no figure of the others is printed.
lacks_a_cell() {
    fails 'a figure is missing: | 2 |  |$' <<'END'
printf '| new | newer |\n|---|---|\n| 1 | 2 |\n'
echo "| 2 | $(false) |"
END
}

has_too_few_cells() {
    fails 'a figure is missing: | 2 |$' <<'END'
printf '| new | newer |\n|---|---|\n| 1 | 2 |\n| 2 |\n'
END
}

has_no_rows() {
    fails 'there are no rows' <<'END'
printf '| new |\n|---|\n'
END
}

has_no_script() { rm "$own/sim/tools/tables/bridge.sh" && afresh && says 'cannot be measured' --write bridge; }

good() { printf 'printf "| new |\\n|---|\\n| 2 |\\n"\n' | prints; }

# Nothing is measured before all names are known.
unknown_name() { good && afresh && says 'brigde: no such table; there are accuracy bridge ' --write bridge brigde && [ ! -s "$work/said" ]; }
unknown_action() { says '--wrote: there are --write, --check' --wrote bridge; }
part_of_a_page() { says 'parts are for --check' --write bridge:rooms; }

lacks_what_it_needs() {
    rm "$own/build/limner"
    good && afresh && says 'bridge: there is no build/limner; try .make tables.' --write bridge && touch "$own/build/limner"
}

page_is() { # PATTERN, the page on stdin
    cat >"$own/README.md" && cp "$own/README.md" "$own/kept" && says "$1" --write bridge
}
no_end() { good && page | grep -v 'bridge end' | page_is 'has no line for its begin'; }
end_before_begin() { { echo '<!-- bridge end -->'; page; } | page_is 'has no line for its begin'; }
twice_in_a_page() { { page; page; } | page_is 'has no line for its begin'; }
nowhere() { echo 'Nothing.' | page_is '0 pages have that table'; }
in_two_pages() {
    mkdir -p "$own/hal"
    page >"$own/hal/README.md"
    page | page_is '2 pages have that table' && rm "$own/hal/README.md"
}

# One that fails takes no other with it.
goes_on() {
    afresh && cat >>"$own/README.md" <<'END' && cp "$own/README.md" "$own/kept"
<!-- delta begin: make tables -->
| old |
|---|
| 1 |
<!-- delta end -->
END
    echo false >"$own/sim/tools/tables/delta.sh"
    ! run --write delta bridge && grep -q '^bridge: README.md$' "$work/said" && sed '3s/old/new/; 5s/1/2/' "$own/kept" | diff - "$own/README.md"
}

tap_check "a table is written between its lines, and nothing else of its page" writes_its_table_alone
tap_check "a page that says something else is told" tells_a_difference
tap_check "pictures are drawn when it is written" pictures_come_with_it
tap_check "one that fails in the middle is not written" ends_in_the_middle
tap_check "nor one with an empty cell" lacks_a_cell
tap_check "nor one with too few" has_too_few_cells
tap_check "nor one without rows" has_no_rows
tap_check "nor one without a script" has_no_script
tap_check "no such table" unknown_name
tap_check "no such action" unknown_action
tap_check "a part is only checked" part_of_a_page
tap_check "what a table needs is named, with what brings it" lacks_what_it_needs
tap_check "a page without the table's end" no_end
tap_check "an end before the begin" end_before_begin
tap_check "a table twice in a page" twice_in_a_page
tap_check "a table in no page" nowhere
tap_check "a table in two pages" in_two_pages
tap_check "the others are written all the same" goes_on
tap_done
