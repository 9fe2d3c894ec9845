# SPDX-License-Identifier: MIT
#
# The page of extremes: what the lines say that tests/extremes/test_extreme_*.c printed ("# extreme-about NAME SENTENCE", "# extreme
# NAME PROFILE promised ... measured ..."), as Markdown, a picture and a promise a row. sh tests/extremes/extremes.sh FILE FOLDER
# prints the page of the output in FILE; pictures are those in FOLDER.
set -eu

cat <<'END'
# Extremes: what is promised, what was measured

Each row is a test: a scene or generator in `tests/extremes/test_extreme_*.c`, drawn in every precision profile and compared with the
double-precision reference. *Holes* are pixels that show something behind a closed surface; *misplaced* ones show a face
that is not to be seen within a pixel, on a lattice of 1/64 pixels: none means that the order is exact. *Wrong* are pixels
that show another face than the reference: edges that are off by a fraction of a pixel. A picture is the frame of profile
`fast` that shows most faces, each in a colour of its own, wrong pixels in red. `make extremes` writes this page.

| | promised | measured |
|---|---|---|
END
awk -v folder="$2" '
    # Profiles of one promise share it; how much may be wrong is listed after it.
    function promise_of(name,    text, k, plain, groups, group, wrong, of, order) {
        for (k = 1; k <= rows[name]; k++) {
            plain = promised[name, k]
            wrong = ""
            if (match(plain, /, <= [0-9.]+ % wrong/)) {
                wrong = substr(plain, RSTART + 5, RLENGTH - 13)
                plain = substr(plain, 1, RSTART - 1)
            }
            if (!(plain in of)) order[++groups] = plain
            of[plain] = of[plain] (of[plain] == "" ? "" : ", ") "`" profile[name, k] "`"
            if (wrong != "") most[name, plain] = most[name, plain] (most[name, plain] == "" ? "" : ", ") wrong
        }
        for (group = 1; group <= groups; group++) {
            plain = order[group]
            text = text (group > 1 ? "; " : "") plain
            if (most[name, plain] != "") text = text ", at most " most[name, plain] " % wrong"
            if (groups > 1) text = text " in " of[plain]
        }
        return text
    }
    # What all profiles share of their figures is said once.
    function figures_of(name,    k, shared, cell) {
        shared = measured[name, 1]
        if (!match(shared, / in [0-9]+ pixels of [0-9]+ frames$/)) shared = ""
        else shared = substr(shared, RSTART)
        for (k = 2; k <= rows[name]; k++)
            if (substr(measured[name, k], length(measured[name, k]) - length(shared) + 1) != shared) shared = ""
        cell = shared == "" ? "" : substr(shared, 5) ":"
        for (k = 1; k <= rows[name]; k++)
            cell = cell (cell == "" ? "" : "<br>") "`" profile[name, k] "`: " \
                substr(measured[name, k], 1, length(measured[name, k]) - length(shared))
        return cell
    }
    function picture_of(name,    file, line) {
        file = name
        gsub("/", "", file)
        file = file ".png"
        return (getline line <(folder "/" file)) < 0 ? "" : "![" name "](pictures/" file ")"
    }
    $2 == "extreme-about" {
        name = $3
        sub(/^# extreme-about [^ ]* /, "")
        about[name] = $0
    }
    $2 == "extreme" {
        name = $3
        if (!(name in rows)) names[++count] = name
        k = ++rows[name]
        profile[name, k] = $4
        sub(/^# extreme [^ ]* [^ ]* promised /, "")
        at = index($0, " measured ")
        promised[name, k] = substr($0, 1, at - 1)
        measured[name, k] = substr($0, at + 10)
    }
    END {
        for (n = 1; n <= count; n++) {
            name = names[n]
            printf "| %s | **%s.** %s: %s. | %s |\n", picture_of(name), name, about[name], promise_of(name), figures_of(name)
        }
    }' "$1"
