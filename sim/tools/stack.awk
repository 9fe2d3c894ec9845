# SPDX-License-Identifier: MIT
#
# The worst-case stack of functions, from what gcc -fcallgraph-info=su writes: awk -f sim/tools/stack.awk
# -v roots='lim_init lim_frame' [-v only='...'] POINTERS *.ci
# POINTERS is what sim/tools/pointers.awk says of the sources. Prints the bytes of the deepest root, and the path there.
# An error: recursion, a frame without bound, a call through a pointer of which the sources do not say where it leads to.
# Where none of its functions is in the graphs it leads to somebody else's, whose stack comes on top: a target that the
# renderer does not know. `only`, if given, are the functions that were linked: no other counts.

# Code of the compiler's own library, written in assembly or without call graph: more than any of it takes.
BEGIN {
    library_b = 64
    some_left_out = split(only, names, " ")
    for (i = 1; i <= some_left_out; i++) is_linked[as_declared(names[i])] = 1
}

function fail(text) {
    print "stack: " text > "/dev/stderr"
    failed = 1
    exit 1
}

function quoted(key,   rest) {
    rest = substr($0, index($0, key ": \"") + length(key) + 3)
    return substr(rest, 1, index(rest, "\"") - 1)
}

# A symbol as C has it: without the configuration that firmware/agree.h puts behind it.
function as_declared(symbol) {
    sub(/^\*/, "", symbol)
    sub(/\.needs_same_LIM_CONFIG.*/, "", symbol)
    return symbol
}

# A function's own name: that of a static one is FILE:NAME.
function plain(title,   parts, n) {
    n = split(title, parts, ":")
    sub(/\.(isra|constprop|part|cold)(\.[0-9]+)*/, "", parts[n])
    return parts[n]
}

function is_left_out(title) {
    return some_left_out && !(plain(title) in is_linked)
}

# POINTERS: where there is a call, and what may be called. Graphs of AVR, which know no columns, are not exact in lines
# either: there it is any call of the file.
$1 == "call" {
    pointers[$2] = pointers[$2] " " $3
    split($2, parts, ":")
    if (index(pointers[parts[1]] " ", " " $3 " ") == 0) pointers[parts[1]] = pointers[parts[1]] " " $3
}
$1 == "to" { leads[$2] = leads[$2] " " $3 ($4 == "elsewhere" ? "/" : "") }

/^node: / {
    title = as_declared(quoted("title"))
    label = quoted("label")
    if (label !~ / bytes \(/ || is_left_out(title)) next
    if (label ~ /bytes \(dynamic\)/) fail(plain(title) ": its stack has no bound")
    home[title] = split(label, parts, "\\\\n") == 3 ? base_of(parts[2]) : ""
    own_b[title] = label
    sub(/.*\\n/, "", own_b[title])
    own_b[title] += 0
    by_name[plain(title)] = title
    titles[plain(title)] = titles[plain(title)] " " title
}

/^edge: / {
    from = as_declared(quoted("sourcename"))
    to = as_declared(quoted("targetname"))
    if (is_left_out(from)) next
    if (to == "__indirect_call") {
        place = quoted("label")
        at = place ~ /:[0-9]+:[0-9]+$/ ? base_of(place) ":" line_of(place) : base_of(place)
        if (!(at in pointers)) fail(place ": calls through a pointer, and nobody says where to")
        to = "*" at
    }
    callees[from] = callees[from] " " to
}

# The file and the line of a place PATH:LINE:COLUMN, of which the column may be missing.
function base_of(place) {
    sub(/:.*/, "", place)
    sub(/.*\//, "", place)
    return place
}

function line_of(place) {
    sub(/^[^:]*:/, "", place)
    return place + 0
}

# The functions that a place's pointers reach from a file.
function reached(place, from,   list, words, n, m, i, k, names, name) {
    n = split(pointers[place], list, " ")
    for (i = 1; i <= n; i++) {
        m = split(leads[list[i]], words, " ")
        for (k = 1; k <= m; k++) {
            name = words[k]
            if (sub(/\/$/, "", name) && index(name, home[from] ":") == 1) continue
            names = names " " name
        }
    }
    return names
}

# Of what may be called at a place from a function, that which goes deepest; "": nothing that is there. A pointer's
# functions are FILE:NAME, of which FILE is - where any file may call NAME; / behind it: not through a pointer in FILE.
function deepest_at(place, from,   list, n, i, candidates, count, k, bytes, most_b, most) {
    n = split(reached(place, from), list, " ")
    for (i = 1; i <= n; i++) {
        count = split(titles_of(list[i]), candidates, " ")
        for (k = 1; k <= count; k++) {
            bytes = deepest(candidates[k])
            if (most != "" && bytes <= most_b) continue
            most_b = bytes
            most = candidates[k]
        }
    }
    return most
}

# The graph's functions that are FILE:NAME. Of a static one that is not known to be of another file, all: graphs of AVR
# have no files.
function titles_of(wanted,   parts, list, n, i, found) {
    split(wanted, parts, ":")
    n = split(titles[parts[2]], list, " ")
    for (i = 1; i <= n; i++)
        if (parts[1] == "-" || home[list[i]] == "" || home[list[i]] == parts[1]) found = found " " list[i]
    return found
}

# Bytes of a function and all that it calls; `via` is the deepest way there.
function deepest(title,   list, n, i, callee, below_b, most_b, name) {
    if (title in known_b) return known_b[title]
    if (!(title in own_b)) {
        via[title] = plain(title) " " library_b
        return known_b[title] = library_b
    }
    if (title in entered) fail(plain(title) ": calls itself")
    entered[title] = 1
    name = plain(title)
    n = split(callees[title], list, " ")
    for (i = 1; i <= n; i++) {
        callee = list[i]
        if (sub(/^\*/, "", callee)) callee = deepest_at(callee, title)
        if (callee == "") continue
        below_b = deepest(callee)
        if (below_b <= most_b) continue
        most_b = below_b
        via[title] = via[callee]
    }
    via[title] = name " " own_b[title] (most_b ? ", " via[title] : "")
    delete entered[title]
    return known_b[title] = own_b[title] + most_b
}

END {
    if (failed) exit 1
    count = split(roots, names, " ")
    for (i = 1; i <= count; i++) {
        if (!(names[i] in by_name)) fail(names[i] ": no such function")
        bytes = deepest(by_name[names[i]])
        if (bytes <= worst_b) continue
        worst_b = bytes
        worst = by_name[names[i]]
    }
    print worst_b ": " via[worst]
}
