# SPDX-License-Identifier: MIT
#
# Judges what one test program printed in the Test Anything Protocol. Variables: name, status (its exit
# status), took_s, limit_s; file names: errors (its stderr), tally ("passed failed skipped" goes there), report
# (failures with diagnostics, skips with reasons). Prints the program's line.
# cmocka's ways are understood: a skip is "not ok N # SKIP NAME", and its reason a plain line before it;
# each group of tests has a plan of its own.

function say(text) { print text > report }

function problem(text) {
    failed++
    say("FAILED  " name ": " text)
}

# Plain lines come before the result that they belong to, lines with a # after it.
function say_plain() { if (plain != "") printf "%s", plain > report }

BEGIN {
    passed = failed = skipped = 0
    printf "" > report
}

/^1\.\.[0-9]+/ {
    planned += substr($1, 4)
    plans++
    if (match(toupper($0), /# *SKIP/)) {
        skipped++
        say("skipped " name ": all of it:" substr($0, RSTART + RLENGTH))
    }
    next
}

/^(not )?ok( |$)/ {
    count++
    failing = 0
    if (match(toupper($0), /# *SKIP/)) {
        skipped++
        say("skipped " name ": " $0)
        say_plain()
    } else if ($1 == "ok") {
        passed++
    } else {
        failing = 1
        problem($0)
        say_plain()
    }
    plain = ""
    next
}

/^Bail out!/ { bailed = $0 }

/^#/ {
    if (failing) say("        " $0)
    next
}

{ plain = plain "        " $0 "\n" }

END {
    if (bailed != "") problem(bailed)
    else if (plans && count == planned && (status == 0 || failed)) ; # it kept its word
    else if (status == 124) problem("timed out after " limit_s " s, " count + 0 " tests done")
    else if (status > 128) problem("crashed with signal " status - 128 ", " count + 0 " tests done")
    else if (!plans) problem("exit status " status " and no plan, " count + 0 " tests done")
    else if (count != planned) problem(planned " tests planned, " count + 0 " done")
    else problem("exit status " status ", though no test failed")
    if (failed) {
        say_plain()
        while ((getline line < errors) > 0) say("        " line)
    }
    printf "%-28s %d passed, %d failed%s (%d s)\n", name, passed, failed, skipped ? ", " skipped " skipped" : "", took_s
    print passed, failed, skipped > tally
}
