# SPDX-License-Identifier: MIT
#
# The test runner counts right and lets nothing pass that did not: made-up programs, good and bad.
. tests/tap.sh

# program NAME: makes a test program of the script on stdin.
program() {
    { echo '#!/bin/sh' && cat; } >"$work/$1"
    chmod +x "$work/$1"
}

# expect STATUS CLOSING-LINE NAME...: runs the programs and looks at the last line; $work/said has all lines.
expect() {
    wanted_status=$1 wanted_line=$2
    shift 2
    (cd "$work" && TEST_TIMEOUT_S=2 sh "$OLDPWD/tests/run.sh" "$@") >"$work/said" 2>&1
    status=$?
    cat "$work/said"
    [ $status -eq "$wanted_status" ] && [ "$(tail -n 1 "$work/said")" = "$wanted_line" ] &&
        [ "$(grep -cE '^[0-9]+ passed, [0-9]+ failed' "$work/said")" -eq 1 ]
}

# Also wants TEXT somewhere in the output.
expect_text() { # TEXT, then as expect
    text=$1
    shift
    expect "$@" && grep -qF -- "$text" "$work/said"
}

program ./good <<'EOF'
echo 1..2; echo ok 1 - one; echo ok 2 - two
EOF
program ./plan_last <<'EOF'
echo ok 1; echo 1..1
EOF
program ./two_groups <<'EOF'
echo 1..1; echo ok 1 - a; echo 1..2; echo ok 1 - b; echo ok 2 - c
EOF
program ./bad <<'EOF'
echo 1..2; echo ok 1 - one; echo not ok 2 - two; echo '# 1 != 2'; exit 1
EOF
program ./bad_but_says_0 <<'EOF'
echo 1..1; echo not ok 1 - one
EOF
program ./skips <<'EOF'
echo 1..2; echo ok 1 - one; echo 'ok 2 - two # SKIP no display'
EOF
program ./cmocka_skips <<'EOF'
echo 1..2; echo ok 1 - one; echo no display here; echo 'not ok 2 # SKIP two'
EOF
program ./skips_all <<'EOF'
echo '1..0 # SKIP no hardware'
EOF
program ./crashes <<'EOF'
echo 1..2; echo ok 1 - one; kill -SEGV $$
EOF
program ./stops_early <<'EOF'
echo 1..3; echo ok 1 - one
EOF
program ./too_many <<'EOF'
echo 1..1; echo ok 1; echo ok 2
EOF
program ./silent <<'EOF'
exit 0
EOF
program ./no_plan <<'EOF'
echo ok 1 - one
EOF
program ./dies_after <<'EOF'
echo 1..1; echo ok 1 - one; echo out of luck >&2; exit 3
EOF
program ./bails <<'EOF'
echo 1..1; echo ok 1 - one; echo 'Bail out! no disk'
EOF
program ./hangs <<'EOF'
echo 1..1; echo ok 1 - one; sleep 60
EOF

tap_check "passes are counted over programs" expect 0 "5 passed, 0 failed" ./good ./two_groups
tap_check "the plan may come last" expect 0 "1 passed, 0 failed" ./plan_last
tap_check "a failure fails the run" expect 1 "3 passed, 1 failed" ./good ./bad
tap_check "a failure is shown by name" expect_text "FAILED  bad: not ok 2 - two" 1 "1 passed, 1 failed" ./bad
tap_check "a failure is shown with its diagnostics" expect_text "# 1 != 2" 1 "1 passed, 1 failed" ./bad
tap_check "exit status 0 does not hide a failure" expect 1 "0 passed, 1 failed" ./bad_but_says_0
tap_check "a skip is counted and its reason shown" expect_text "no display" 0 "1 passed, 0 failed, 1 skipped" ./skips
tap_check "cmocka's skip is a skip" expect_text "no display here" 0 "1 passed, 0 failed, 1 skipped" ./cmocka_skips
tap_check "a program may skip as a whole" expect_text "no hardware" 0 "2 passed, 0 failed, 1 skipped" ./good ./skips_all
tap_check "nothing but skips is not a success" expect 1 "0 passed, 0 failed, 1 skipped" ./skips_all
tap_check "a crash is a failure" expect_text "signal 11" 1 "1 passed, 1 failed" ./crashes
tap_check "fewer tests than planned is a failure" expect_text "3 tests planned, 1 done" 1 "1 passed, 1 failed" ./stops_early
tap_check "more tests than planned is a failure" expect 1 "2 passed, 1 failed" ./too_many
tap_check "silence is a failure" expect_text "no plan" 1 "0 passed, 1 failed" ./silent
tap_check "tests without a plan are a failure" expect 1 "1 passed, 1 failed" ./no_plan
tap_check "a bad exit status alone is a failure" expect_text "out of luck" 1 "1 passed, 1 failed" ./dies_after
tap_check "bailing out is a failure" expect_text "no disk" 1 "1 passed, 1 failed" ./bails
tap_check "a hang is a failure" expect_text "timed out after 2 s" 1 "1 passed, 1 failed" ./hangs
tap_check "a program that is not there is a failure" expect 1 "2 passed, 1 failed" ./good ./absent
tap_check "no program at all is not a success" expect 1 "0 passed, 0 failed"

# -- How far it is -------------------------------------------------------------------------------------------------------

program ./slow <<'EOF'
echo 1..1; sleep 3; echo ok 1 - one
EOF

# The first run knows no times, and leaves them; the second one says how long it will take, and what runs meanwhile.
tells_times() {
    rm -f "$work/times"
    (cd "$work" && TEST_TIMES=times TEST_JOBS=1 TEST_TELL_S=1 sh "$OLDPWD/tests/run.sh" ./slow ./good) >"$work/said" || return 1
    cat "$work/said" "$work/times"
    grep -qx '2 test programs, 1 at once' "$work/said" && grep -q '^good [01]$' "$work/times" && grep -q '^slow [34]$' "$work/times" &&
        grep -q '^\[1/2\] slow  *1 passed' "$work/said" && grep -q '^\[2/2\] good  *2 passed' "$work/said" &&
        grep -qx '\.\.\. 0 of 2 done; running: slow' "$work/said" || return 1
    (cd "$work" && TEST_TIMES=times TEST_JOBS=1 TEST_TELL_S=1 sh "$OLDPWD/tests/run.sh" ./good ./slow) >"$work/said" || return 1
    cat "$work/said"
    grep -qE '^2 test programs, 1 at once, about [345] s$' "$work/said" &&
        grep -qE '^\.\.\. 1 of 2 done, about [34] s left; running: slow$' "$work/said"
}
tap_check "times of one run tell how long the next one takes" tells_times
keeps_other_times() {
    echo 'elsewhere 7' >>"$work/times"
    (cd "$work" && TEST_TIMES=times sh "$OLDPWD/tests/run.sh" ./good) >"$work/said" && grep -qx 'elsewhere 7' "$work/times" &&
        grep -q '^slow' "$work/times"
}
tap_check "times of what did not run stay" keeps_other_times
leaves_nothing() { ! grep -lsz '^321[7]$' /proc/[0-9]*/cmdline; }
(cd "$work" && TEST_TELL_S=3217 sh "$OLDPWD/tests/run.sh" ./good) >/dev/null
tap_check "nothing of the runner is left behind" leaves_nothing
tap_done
