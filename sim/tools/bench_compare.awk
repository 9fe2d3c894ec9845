# SPDX-License-Identifier: MIT
#
# See sim/tools/bench_compare.sh. Three files: the compilers now, a line "# CORE: VERSION" each; the baseline, which begins with
# such lines; the new rows. Of pattern only CORE,SCENE,SIZE,PATH that matches it.

FNR == 1 { file++ }

/^# / {
    core = substr($0, 3, index($0, ":") - 3)
    if (file == 1) now[core] = $0
    if (file == 2) then[core] = $0
    next
}

/^core,/ { next }

{ place = $1 "," $2 "," $3 "," $4; key = place "," $5 }

NF != 7 || $6 !~ /^[0-9.]+$/ || $7 !~ /^[0-9.]+$/ { fail(FILENAME ":" FNR ": not a row of seven fields: " $0); next }

place !~ pattern { next }

# Of compilers that count nothing here, nothing is asked.
$1 != "all" && then[$1] != now[$1] { skip($1); next }

file == 2 { mean[key] = $6; worst[key] = $7; order[++count] = key }

file == 3 {
    seen[key] = 1
    compared++
    if (!(key in mean)) print "new        " key ": " $6 ", worst " $7
    else compare(key, $5, $6, $7)
}

END {
    for (i = 1; i <= count; i++)
        if (!(order[i] in seen)) missing(order[i])
    if (failed) exit 1
    if (!compared) {
        print "nothing was compared"
        exit 77
    }
    printf "%d rows compared, %d fell, %d grew\n", compared, fell, grew
}

function skip(core) {
    if (!(core in skipped))
        print "skipped    " core ": counted with " version(core, then[core]) ", but here is " version(core, now[core])
    skipped[core] = 1
}

function version(core, line) {
    return line ? substr(line, length(core) + 5) : "a compiler that nobody named"
}

function fail(why) {
    print why
    failed = 1
}

function missing(key) {
    if (is_stage(key)) print "gone       " key ": a stage, was " mean[key]
    else fail("missing    " key)
}

# All but stages must not grow: whole frames, memory, wrong pixels. More polygons are no growth.
function is_stage(key,   part) {
    split(key, part, ",")
    return part[5] != "frame" && part[5] !~ /_/
}

function percent(from, to) {
    return from == to ? 0 : from == 0 ? 100 : (to - from) * 100 / from
}

function compare(key, stage, mean_now, worst_now,   by_mean, by_worst) {
    by_mean = percent(mean[key], mean_now)
    by_worst = percent(worst[key], worst_now)
    if (by_mean <= 1 && by_mean >= -1 && by_worst <= 1 && by_worst >= -1) return
    word = by_mean > 1 || by_worst > 1 ? (is_stage(key) ? "stage grew" : "GREW") : "fell"
    if (word == "fell") fell++
    else grew++
    if (word == "GREW") failed = 1
    printf "%-10s %s: %s -> %s (%+.1f %%), worst %s -> %s (%+.1f %%)\n", word, key, mean[key], mean_now, by_mean, \
        worst[key], worst_now, by_worst
}
