# SPDX-License-Identifier: MIT
#
# The worst-case stack of functions, from what gcc -fcallgraph-info=su writes: awk -f sim/tools/stack.awk
# -v roots='lim_init lim_frame' [-v calls='span.c=paint_piece ...'] [-v outside='paint.c ...'] *.ci
# `calls` says where a file's calls through a pointer lead, to one function or several of which some are linked; "none"
# among them is a pointer that nobody sets where the others are not linked. Those
# of the files in `outside` lead to somebody else's functions, whose stack comes on top. Prints the bytes of the deepest root, and the path there. An
# error: recursion, a frame without bound, a pointer not accounted for. `only`, if given, are the functions that were linked:
# no other counts.

# Code of the compiler's own library, written in assembly or without call graph: more than any of it takes.
BEGIN {
    library_b = 64
    count = split(calls, pairs, " ")
    for (i = 1; i <= count; i++) {
        at = index(pairs[i], "=")
        file = substr(pairs[i], 1, at - 1)
        leads[file] = leads[file] (file in leads && leads[file] != "" ? "|" : "") substr(pairs[i], at + 1)
    }
    count = split(outside, names, " ")
    for (i = 1; i <= count; i++) is_outside[names[i]] = 1
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

/^node: / {
    title = as_declared(quoted("title"))
    label = quoted("label")
    if (label !~ / bytes \(/ || is_left_out(title)) next
    if (label ~ /bytes \(dynamic\)/) fail(plain(title) ": its stack has no bound")
    own_b[title] = label
    sub(/.*\\n/, "", own_b[title])
    own_b[title] += 0
    by_name[plain(title)] = title
}

# A call through a pointer becomes one of what the pointer leads to.
/^edge: / {
    from = as_declared(quoted("sourcename"))
    to = as_declared(quoted("targetname"))
    if (is_left_out(from)) next
    if (to == "__indirect_call") {
        file = quoted("label")
        sub(/:.*/, "", file)
        sub(/.*\//, "", file)
        if (file in is_outside) next
        if (!(file in leads)) fail(file ": calls through a pointer, and nobody says where to")
        to = "*" leads[file]
    }
    callees[from] = callees[from] " " to
}

# Of what a pointer may lead to, that which goes deepest.
function deepest_of(names,   list, n, i, bytes, most_b, most) {
    n = split(names, list, "|")
    for (i = 1; i <= n; i++) {
        if (!(list[i] in by_name)) continue
        bytes = deepest(by_name[list[i]])
        if (most && bytes <= most_b) continue
        most_b = bytes
        most = by_name[list[i]]
    }
    if (!most && ("|" names "|") !~ /\|none\|/) fail(names ": no such function")
    return most
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
        if (sub(/^\*/, "", callee)) callee = deepest_of(callee)
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
