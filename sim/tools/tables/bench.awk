# SPDX-License-Identifier: MIT
#
# One of the tables of sim/tools/tables/bench.sh: `table` says which. Rows come in the order of the CSV, so that scenes stand as
# sim/tools/bench.sh has them; of sim/tools/tables/peers.txt, which comes first for the table of peers, in its own.

BEGIN {
    core_count = split(cores, core_names, " ")
    split("m0plus Cortex-M0+ m3 Cortex-M3 m4 Cortex-M4F m33 Cortex-M33 rv32 RV32IMC host host", words, " ")
    for (i = 1; i in words; i += 2) title[words[i]] = words[i + 1]
}

/^# lost / { lost[++losses] = substr($0, 8) }
/^# host: / { title["host"] = "host, " $NF } # its processor
/^#/ { next }

/ [|] / { peer_lines[++peers] = $0; next }

{ split($0, field, ",") }

field[1] == "core" { next }

{
    place = field[2] "," field[3] "," field[4]
    mean[field[1] "," place "," field[5]] = field[6]
    worst[field[1] "," place "," field[5]] = field[7]
    if (!(place in known)) { known[place] = 1; places[++place_count] = place }
    if (!((place, field[5]) in known)) {
        known[place, field[5]] = 1
        stages[place] = stages[place] " " field[5]
    }
}

END {
    if (table == "peers") against_peers()
    if (table == "bench") frames()
    if (table == "bench-stages") by_stage()
    if (table == "bench-memory") memory()
}

function number(value) {
    return value == "-" || value == "" ? "-" : sprintf(value >= 100 ? "%.0f" : value >= 1 ? "%.1f" : "%.3f", value)
}

function rule(columns,   line) {
    while (columns--) line = line "---|"
    return line
}

function times(value) {
    return sprintf(value >= 1 ? "%.1f" : "%.2f", value)
}

# "mean / worst", in thousands or as they are.
function pair(key, divisor) {
    if (!(key in mean)) return "-"
    if (mean[key] == worst[key]) return number(mean[key] / divisor)
    return number(mean[key] / divisor) " / " number(worst[key] / divisor)
}

function wrong(place) {
    return pair("all," place ",wrong_percent", 1)
}

function against_peers(   i, p, own, path) {
    print "| | best peer | to reach | Limner | times less | Limner, random cameras | wrong, % | random cameras |"
    print "|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= peers; i++) {
        split(peer_lines[i], p, / *[|] */)
        path = p[5] ~ /^(frame|wrong_percent)$/ ? "own" : "-"
        place = p[3] "," p[4] ","
        own = p[2] "," place path "," p[5]
        if (p[3] == "-") {
            printf "| %s | %s: %s | - | - | - | - | - | - |\n", p[1], p[7], both(p[8], p[9])
            continue
        }
        if (!(own in mean)) {
            print "no row " own >"/dev/stderr"
            exit 1
        }
        printf "| %s | %s | %s | %s | %s | %s | %s | %s |\n", p[1], p[7] == "-" ? "-" : p[7] ": " both(p[8], p[9]),
            both(p[10], p[11]), pair(own, p[6]), p[8] == "-" ? "-" : times(p[8] * p[6] / mean[own]),
            path == "own" ? pair(p[2] "," place "random," p[5], p[6]) : "-",
            p[5] == "frame" ? wrong(place "own") : "-", p[5] == "frame" ? wrong(place "random") : "-"
    }
    if (losses) print "\nWhat is lost, and why:"
    for (i = 1; i <= losses; i++) print "- " lost[i]
}

function both(first, second) {
    return second == "-" ? first : first " / " second
}

function frames(   i, c, place, part) {
    printf "| scene | pixels | cameras |"
    for (c = 1; c <= core_count; c++) printf " %s |", title[core_names[c]]
    print " wrong, % | holes, px |"
    print "|" rule(core_count + 5)
    for (i = 1; i <= place_count; i++) {
        place = places[i]
        split(place, part, ",")
        if (part[3] == "-") continue
        printf "| %s | %s | %s |", part[1], part[2], part[3]
        for (c = 1; c <= core_count; c++) printf " %s |", pair(core_names[c] "," place ",frame", 1000)
        printf " %s | %d |\n", wrong(place), mean["all," place ",holes_px"]
    }
}

function by_stage(   i, k, c, place, part, list, count, key) {
    printf "| scene | stage |"
    for (c = 1; c <= core_count; c++) printf " %s |", title[core_names[c]]
    print "\n|" rule(core_count + 2)
    for (i = 1; i <= place_count; i++) {
        place = places[i]
        split(place, part, ",")
        if (part[2] != "240x240" || part[3] != "own") continue
        count = split(stages[place], list, " ")
        for (k = 1; k <= count; k++) {
            if (list[k] ~ /_/ || list[k] == "frame" || !is_large(place, list[k])) continue
            printf "| %s | %s |", part[1], list[k]
            for (c = 1; c <= core_count; c++) {
                key = core_names[c] "," place "," list[k]
                printf " %s |", is_large_on(core_names[c], place, list[k]) ? number(mean[key] / 1000) : "-"
            }
            print ""
        }
    }
}

# As in the baseline: a twentieth of the frame.
function is_large_on(core, place, stage,   key) {
    key = core "," place ","
    return (key stage) in mean && mean[key stage] * 20 >= mean[key "frame"]
}

function is_large(place, stage,   c) {
    for (c = 1; c <= core_count; c++)
        if (is_large_on(core_names[c], place, stage)) return 1
    return 0
}

function memory(   i, place, part) {
    print "| scene | faces | scene data | a face | code, M0+ | code, M4 | RAM | stack, M0+ | stack, M4 | RAM in all, M0+ | M4 |"
    print "|---|---|---|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= place_count; i++) {
        place = places[i]
        split(place, part, ",")
        if (part[3] != "-") continue
        printf "| %s | %d | %d | %s |", part[1] (part[2] == "240x240" ? "" : ", " part[2]),
            mean["all," place ",faces"], mean["all," place ",scene_b"], number(mean["all," place ",scene_b_a_face"])
        printf " %d | %d | %d |", mean["m0plus," place ",code_b"], mean["m4," place ",code_b"], mean["m4," place ",ram_b"]
        printf " %d | %d | %d | %d |\n", mean["m0plus," place ",stack_b"], mean["m4," place ",stack_b"],
            mean["m0plus," place ",all_ram_b"], mean["m4," place ",all_ram_b"]
    }
}
