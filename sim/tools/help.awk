# SPDX-License-Identifier: MIT
#
# What `make help` prints: awk -f sim/tools/help.awk MAKEFILE... A goal is told by `goal: ... ## [GROUP] what it does`. Exit
# status 1 if a goal's group is none of these.
BEGIN {
    FS = ":.*## "
    count = split("start board test measure care", groups, " ")
    title["start"] = "To begin with"
    title["board"] = "Boards (BOARD=NAME; boards/README.md)"
    title["test"] = "Tests and proofs (tests/README.md)"
    title["measure"] = "Measuring (sim/MEASURED.md); all but bench write tables or pages anew"
    title["care"] = "The rest"
}

/^[a-z0-9-]+:.*## / {
    group = $2
    text = $2
    sub(/^\[/, "", group)
    sub(/\].*/, "", group)
    sub(/^\[[a-z]*\] /, "", text)
    if (!(group in title)) {
        print "make help: " $1 " is in no group" >"/dev/stderr"
        wrong = 1
    }
    lines[group] = lines[group] sprintf("  make %-14s %s\n", $1, text)
}

END {
    for (i = 1; i <= count; i++) printf "%s%s:\n%s", (i > 1 ? "\n" : ""), title[groups[i]], lines[groups[i]]
    exit wrong
}
