# SPDX-License-Identifier: MIT
#
# See sim/tools/bench_compare.sh, --peers. Three files: the baseline, of which the lines `# lost ROW: WHY` are read; the rows of
# sim/tools/tables/peers.txt; what was counted. A row is lost if its mean is larger than the best peer's, or its worst frame is.
# Rows that were not counted are passed over: there may be fewer scenes.

FNR == 1 { file++ }

file == 1 && /^# lost / {
    at = index($0, ": ")
    reason[substr($0, 8, at - 8)] = substr($0, at + 2)
    next
}

file == 1 { next }

file == 2 && / [|] / { line[++count] = $0; next }

file == 3 {
    split($0, field, ",")
    key = field[1] "," field[2] "," field[3] "," field[4] "," field[5]
    mean[key] = field[6]
    worst[key] = field[7]
}

END {
    for (i = 1; i <= count; i++) {
        split(line[i], p, / *[|] */)
        known[p[1]] = 1
        judge(p[1], p[2] "," p[3] "," p[4] "," (p[5] ~ /^(frame|wrong_percent)$/ ? "own" : "-") "," p[5], p[6], p[7], p[8], p[9])
    }
    for (name in reason)
        if (!(name in known)) {
            print "no row     " name ": there is a reason for it, and no such row of peers"
            failed = 1
        }
    exit failed
}

function judge(name, key, divisor, peer, its_mean, its_worst,   lost) {
    if (!(key in mean) || its_mean == "-") return
    lost = mean[key] / divisor > its_mean + 0 || (its_worst != "-" && worst[key] / divisor > its_worst + 0)
    if (!lost) {
        if (name in reason) print "won        " name ": its reason may go from the baseline: " reason[name]
        return
    }
    printf "%-10s %s: %.4g / %.4g, %s: %s / %s; %s\n", name in reason ? "lost" : "LOST", name, mean[key] / divisor, \
        worst[key] / divisor, peer, its_mean, its_worst, name in reason ? reason[name] : "the baseline has no reason"
    if (!(name in reason)) failed = 1
}
