# SPDX-License-Identifier: MIT
#
# Which builds hold pairs of features: a line for each pair, bare (what a scene needs and the pair) and full (all but the
# pair), and scene, in the order in which scenes are to be tried:
#
#   PAIR bare|full SCENE LIM_HAS_X=1...
#
# Reads the scenes' headers, whose names are .../SCENE/model.h. `features` are the flags, `seed` says which eighth of the
# pairs (seed mod 8), whether bare or full, and which scene comes first; with `all`=1 it is all pairs, both ways. What a flag needs or is needed by follows it, as
# far as that is a matter of one other; the rest is up to agree.h. A flag that the scene needs stays as it is.

function of_scene(path, part, count) {
    count = split(path, part, "/")
    return part[count - 1]
}

FNR == 1 {
    scene[scenes++] = of_scene(FILENAME)
}

/#define LIM_HAS_/ {
    needs[scenes - 1, $2] = $3
}

# What the scene's header leaves open: what it does without, or never speaks of.
function open_to(at, name) {
    return !needs[at, name]
}

# Bare, a pair is what the scene does not have: off is what is on by default.
function turned(name) {
    return (name == "LIM_HAS_LINES" || name == "LIM_RECIP_TABLE") ? 0 : 1
}

function follow_on(on) {
    if (is(on, "LIGHT", 1) || is(on, "DEFORM", 1)) on["LIM_HAS_MOVERS"] = 1
    if (is(on, "LARGE", 1)) on["LIM_HAS_SLANTED"] = 1
    if (is(on, "PORTALS", 1)) on["LIM_HAS_CULL"] = 1
    if (is(on, "MESH_LEAVES", 1)) on["LIM_HAS_LEAVES"] = 1
    if (is(on, "LINES", 0)) on["LIM_HAS_FILL"] = 1
    if (is(on, "MASKED", 1)) on["LIM_HAS_TEXTURE"] = on["LIM_HAS_TRANSPARENT"] = 1
    if (is(on, "SKY", 1)) on["LIM_HAS_TEXTURE"] = 1
}

function follow_off(on) {
    if (is(on, "NEAREST", 0) && is(on, "PAINTER", 0)) {
        on["LIM_HAS_FRAMEBUFFER"] = 0
        if (is(on, "SCANLINE", 0)) on["LIM_HAS_MESH_LEAVES"] = on["LIM_HAS_LONG"] = 0
    }
    if (is(on, "NEAREST", 0) && is(on, "SCANLINE", 0)) on["LIM_HAS_MOVERS"] = 0
    if (is(on, "NEAREST", 0) && is(on, "CONVEX", 0)) on["LIM_HAS_FILL"] = 0
    if (is(on, "MOVERS", 0)) on["LIM_HAS_LIGHT"] = on["LIM_HAS_DEFORM"] = 0
    if (is(on, "SLANTED", 0)) on["LIM_HAS_LARGE"] = 0
    if (is(on, "CULL", 0)) on["LIM_HAS_PORTALS"] = 0
    if (is(on, "LEAVES", 0)) on["LIM_HAS_MESH_LEAVES"] = 0
    if (is(on, "TEXTURE", 0)) on["LIM_HAS_MASKED"] = on["LIM_HAS_SKY"] = 0
    if (is(on, "TRANSPARENT", 0)) on["LIM_HAS_MASKED"] = 0
}

function is(on, name, value) {
    return ("LIM_HAS_" name in on) && on["LIM_HAS_" name] == value
}

function flags_of(side, a, b, on, i, text) {
    for (i in on) delete on[i]
    if (side == "full")
        for (i = 1; i <= count; i++) on[name[i]] = 1
    on[a] = side == "full" ? 0 : turned(a)
    on[b] = side == "full" ? 0 : turned(b)
    if (side == "full") follow_off(on)
    else follow_on(on)
    for (i = 1; i <= count; i++)
        if (name[i] in on) text = text " " name[i] "=" on[name[i]]
    return text
}

END {
    count = split(features, name, " ")
    at = -1
    for (a = 1; a <= count; a++)
        for (b = a + 1; b <= count; b++) {
            at++
            for (side = 0; side < 2; side++) {
                if (!all && ((at + seed) % 8 || (at + int(at / 8) + int(seed / 8)) % 2 != side)) continue
                for (try = 0; try < scenes; try++) {
                    where = (at * 5 + int(seed / 8) + try) % scenes
                    if (!open_to(where, name[a]) || !open_to(where, name[b])) continue
                    print name[a] "," name[b], side ? "full" : "bare", scene[where] flags_of(side ? "full" : "bare", name[a], name[b])
                }
            }
        }
}
