# SPDX-License-Identifier: MIT
#
# Relative links of Markdown pages: awk -f tests/links.awk PAGE... Names each link whose file, or whose heading in a page,
# does not exist. Exit status 1 if there is one, and if there is no link at all. Anchors are made of headings as GitHub
# makes them.

function folder_of(path) { return match(path, /.*\//) ? substr(path, 1, RLENGTH) : "" }

# a/b/../c, ./a: as the shell would find it, without the detours.
function plain(path,    count, parts, kept, i, out) {
    count = split(path, parts, "/")
    kept = 0
    for (i = 1; i <= count; i++) {
        if (parts[i] == "." || parts[i] == "") continue
        if (parts[i] == ".." && kept && stack[kept] != "..") kept--
        else stack[++kept] = parts[i]
    }
    out = substr(path, 1, 1) == "/" ? "/" : ""
    for (i = 1; i <= kept; i++) out = out (i > 1 ? "/" : "") stack[i]
    return out
}

function anchor_of(heading) {
    gsub(/\]\([^)]*\)/, "", heading)
    heading = tolower(heading)
    gsub(/[^a-z0-9_ -]/, "", heading)
    gsub(/ /, "-", heading)
    return heading
}

function note_heading(line,    anchor) {
    sub(/^#+ +/, "", line)
    sub(/ +#* *$/, "", line)
    anchor = anchor_of(line)
    if (page SUBSEP anchor in anchors) anchor = anchor "-" (++repeats[page, anchor])
    anchors[page, anchor] = 1
}

function note_links(line,    target) {
    gsub(/`[^`]*`/, "", line)
    while (match(line, /\]\([^) ]+\)/)) {
        target = substr(line, RSTART + 2, RLENGTH - 3)
        line = substr(line, RSTART + RLENGTH)
        if (target ~ /^[a-z]+:/) continue
        links[++link_count] = target
        link_page[link_count] = page
        link_line[link_count] = FNR
    }
}

function complain(i, reason) {
    print link_page[i] ":" link_line[i] ": " links[i] ": " reason
    broken = 1
}

function check(i,    hash, path, anchor) {
    hash = index(links[i], "#")
    path = hash ? substr(links[i], 1, hash - 1) : links[i]
    anchor = hash ? substr(links[i], hash + 1) : ""
    path = path == "" ? link_page[i] : plain(folder_of(link_page[i]) path)
    if (!(path in exists)) exists[path] = system("test -e '" path "'") == 0
    if (!exists[path]) complain(i, "there is no such file")
    else if (anchor != "" && !(path in pages)) complain(i, "no page that was looked at")
    else if (anchor != "" && !((path, anchor) in anchors)) complain(i, "the page has no such heading")
}

FNR == 1 {
    page = plain(FILENAME)
    pages[page] = 1
    fenced = 0
}
/^ *```/ { fenced = !fenced }
fenced || /^    / { next }
/^#+ / { note_heading($0) }
{ note_links($0) }

END {
    for (i = 1; i <= link_count; i++) check(i)
    if (!link_count) print "there is no link at all"
    exit broken || !link_count
}
