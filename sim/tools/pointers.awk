# SPDX-License-Identifier: MIT
#
# Where calls through pointers lead, as the C says it: awk -f sim/tools/pointers.awk SOURCE... (all of firmware/, hal/ and
# boards/). Prints for sim/tools/stack.awk
#   call FILE:LINE POINTER                       a call through it
#   to POINTER FILE:FUNCTION [elsewhere]         a function that it may lead to; `elsewhere`: but not from that file
# A POINTER is one of two:
#   - a struct's member, `target.lend`: the last word of the struct's name, and the member's. Whoever calls through it or
#     sets it has named the struct by that word: target->lend(...), view.target.lend = f, (struct lim_target){.lend = f}.
#   - a type of functions, `lim_mask_sink`, of parameters, variables and members `lim_mask_sink *sink`. A function that is
#     given to one is declared by the type: `static lim_mask_sink push;`, so that the compiler compares the two.
# Behind where a function is set may stand: /* never called from this file */; behind a type's declaration: /* program's */,
# of a function that nobody here has, but whoever uses the renderer.
# An error, with file and line: a function whose address is taken otherwise, a member that nobody calls or that nothing
# is set to, a pointer's value that goes elsewhere.

FNR == 1 {
    in_comment = in_directive = 0
    base = FILENAME
    sub(/.*\//, "", base)
    files[++file_count] = FILENAME
    bases[file_count] = base
}

{
    line[file_count, FNR] = code_of($0)
    lines[file_count] = FNR
    if ($0 ~ /\/\* never called from this file \*\//) is_elsewhere[file_count, FNR] = 1
    if ($0 ~ /^typedef .*\/\* program's \*\//) {
        name = $0
        sub(/\(.*/, "", name)
        sub(/.*[ *]/, "", name)
        is_programs[name]
    }
}

# A line without comments and texts; of directives what macros stand for.
function code_of(text,   code, at, next_at) {
    if (in_directive || (!in_comment && text ~ /^ *#/)) {
        if (!in_directive) is_macro = sub(/^ *# *define [A-Za-z_0-9]+(\([^)]*\))?/, "", text)
        in_directive = sub(/\\$/, "", text)
        if (!is_macro) return ""
        text = " " text
    }
    gsub(/__attribute__\(\(([^()]|\([^()]*\))*\)\)/, "", text)
    gsub(/"([^"\\]|\\.)*"/, "\"\"", text)
    gsub(/'([^'\\]|\\.)+'/, "0", text)
    while (text != "") {
        if (in_comment) {
            at = index(text, "*/")
            if (!at) return code
            text = substr(text, at + 2)
            in_comment = 0
            continue
        }
        at = index(text, "/*")
        next_at = index(text, "//")
        if (next_at && (!at || next_at < at)) return code substr(text, 1, next_at - 1)
        if (!at) return code text
        code = code substr(text, 1, at - 1)
        text = substr(text, at + 2)
        in_comment = 1
    }
    return code
}

function wrong(text) {
    print files[file] ":" row ": " text > "/dev/stderr"
    failed = 1
}

function last_word(text) {
    sub(/.*_/, "", text)
    return text
}

# The last name in a text, as `target` of "delta->target".
function last_name(text) {
    return match(text, /[A-Za-z_][A-Za-z_0-9]*$/) ? substr(text, RSTART) : ""
}

# -- Declarations --------------------------------------------------------------------------------------------------------

# Types of functions, members that are pointers, functions.
function read_declarations(text,   name) {
    note_struct(text)
    if (text ~ /^typedef .*[ *][a-z_0-9]+\(/ && text !~ /\(\*/) {
        name = text
        sub(/\(.*/, "", name)
        add_type(last_name(name))
    } else if (match(text, /\(\*[a-z_0-9]+(\[[^]]*\])?\)\(/)) {
        name = substr(text, RSTART + 2, RLENGTH - 4)
        if (tag == "" || name ~ /\[/) wrong(name ": is no struct's member: declare a type of functions for it")
        else add_member(tag, name, last_word(tag) "." name)
    } else if (text ~ /^[A-Za-z_]/) {
        name = declared_function(text)
        if (name != "") add_function(name, text)
    }
}

# Of two types for the same functions the compiler takes one for the other.
function add_type(name,   at, kind) {
    is_type[name] = 1
    for (at = row; at <= lines[file]; at++) {
        kind = kind line[file, at]
        if (line[file, at] ~ /;$/) break
    }
    sub(name "\\(", "(", kind)
    gsub(/[a-z_0-9]+[,)]/, ",", kind)
    gsub(/ /, "", kind)
    if ((kind in type_like) && type_like[kind] != name) wrong(name ": is the same type as " type_like[kind])
    type_like[kind] = name
}

# The struct whose members are declared here: its tag, or "".
function note_struct(text) {
    if (match(text, /struct [a-z_0-9]+ \{$/)) tag = substr(text, RSTART + 7, RLENGTH - 9)
    else if (text ~ /^ *\}/) tag = ""
}

function add_member(tag, name, pointer,   word) {
    word = last_word(tag)
    if (((word, name) in member_by_word) && member_by_word[word, name] != pointer) wrong(name ": is another pointer in another struct ..._" word)
    member[tag, name] = member_by_word[word, name] = pointer
}

function declared_function(text,   word) {
    while (match(text, /[A-Za-z_][A-Za-z_0-9]*\(/)) {
        word = substr(text, RSTART, RLENGTH - 1)
        text = substr(text, RSTART + RLENGTH)
        if (word ~ /[a-z]/ && word !~ /^_/ && word != "sizeof") return word
    }
    return ""
}

function add_function(name, text) {
    if (text ~ /^(.* )?static / && bases[file] ~ /\.c$/) owner_here[file, name] = bases[file]
    else owner_anywhere[name] = "-"
}

# "-": a function that other files can call; FILE: one of this file; "": no function.
function owner(name) {
    if ((file, name) in owner_here) return owner_here[file, name]
    return name in owner_anywhere ? owner_anywhere[name] : ""
}

# Functions, members, parameters and variables of such types, and which structs names in a file stand for.
function read_types(text,   rest, type, name) {
    note_struct(text)
    if (match(text, /^(static )?[a-z_0-9]+ [a-z_0-9]+;$/)) {
        name = substr(text, 1, length(text) - 1)
        sub(/^static /, "", name)
        split(name, parts, " ")
        if (parts[1] in is_type) {
            add_function(parts[2], text)
            put(parts[1], parts[2])
            type_of_function[owner(parts[2]), parts[2]] = parts[1]
        }
    }
    for (rest = text; match(rest, /[a-z_0-9]+ \*(const )?[a-z_0-9]+/); rest = substr(rest, RSTART + RLENGTH)) {
        name = substr(rest, RSTART, RLENGTH)
        type = name
        sub(/ .*/, "", type)
        if (!(type in is_type) || substr(rest, RSTART + RLENGTH) ~ /^\(/) continue
        name = last_name(name)
        if (tag != "") add_member(tag, name, type)
        else note_variable(name, type)
    }
    for (rest = text; match(rest, /struct [a-z_0-9]+ \**(const )?[a-z_0-9]+/); rest = substr(rest, RSTART + RLENGTH)) {
        split(substr(rest, RSTART, RLENGTH), parts, " ")
        name = last_name(substr(rest, RSTART, RLENGTH))
        structs_of[file, name] = structs_of[file, name] " " parts[2]
    }
}

function note_variable(name, type) {
    if (((file, name) in variable) && variable[file, name] != type) wrong(name ": has two types in one file")
    variable[file, name] = type
}

# -- Uses ----------------------------------------------------------------------------------------------------------------

function put(pointer, name,   where) {
    where = "to " pointer " " owner(name) ":" name (((file, row) in is_elsewhere) ? " elsewhere" : "")
    if (!(where in is_put)) print where
    is_put[where] = is_set[pointer] = 1
}

function put_call(pointer) {
    print "call " bases[file] ":" row " " pointer
    if (!(pointer in called_at)) called_at[pointer] = files[file] ":" row
}

# The pointer that a member of a struct of that name is, or "".
function pointer_of(holder, name,   i, count) {
    if ((file, holder) in structs_of) {
        count = split(structs_of[file, holder], parts, " ")
        for (i = 1; i <= count; i++)
            if ((parts[i], name) in member) return member[parts[i], name]
        return ""
    }
    return (holder, name) in member_by_word ? member_by_word[holder, name] : ""
}

function read_uses(text,   rest, before, word) {
    if (text ~ /^[A-Za-z_}]/) split("", is_local)
    for (rest = text; match(rest, /[A-Za-z_][A-Za-z_0-9]*/); before = before word) {
        before = before substr(rest, 1, RSTART - 1)
        word = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        if (before ~ /struct $/ && rest ~ /^(\)(\{|$)|[ ][a-z_0-9]+(\[[^]]*\])? = )/) initialised = word
        if (before ~ /(->|[^0-9.]\.|^\.)$/) use_member(before, word, rest)
        else if (is_declared(text, before, rest)) is_local[word] = 1
        else if (rest ~ /^\(/) use_call(word)
        else if (!(word in is_local) && (text !~ /^[A-Za-z_]/ || before ~ /\{/)) use_function(before, word)
    }
}

# A name behind that of a type, or behind another one that is declared.
function is_declared(text, before, rest) {
    if (before ~ /(^|[^A-Za-z_0-9])(return|case|else|goto|sizeof) [*]*$/) return 0
    if (before ~ /[A-Za-z_0-9] [*]*$/ && before !~ /(struct|enum|union) $/) return 1
    if (text !~ /^ +(const |static |(struct|enum) [a-z_0-9]+ |bool |int |unsigned |size_t |[a-z_0-9]+_t )/) return 0
    return before ~ /, [*]*$/ && gsub(/[({]/, "", before) == gsub(/[)}]/, "", before)
}

function use_member(before, name, rest,   holder, pointer) {
    holder = before
    sub(/(->|\.)$/, "", holder)
    holder = last_name(holder)
    if (rest ~ /^\(/) {
        pointer = pointer_of(holder, name)
        if (pointer == "") wrong("calls through " holder "." name ", and no struct " holder " or ..._" holder " has such a pointer")
        else put_call(pointer)
    } else if (rest ~ /^ = /) {
        if (before ~ /(^|[ ({,])\.$/) pointer = (initialised, name) in member ? member[initialised, name] : ""
        else pointer = pointer_of(holder, name)
        if (pointer != "") use_set(pointer, rest)
    } else {
        pointer = pointer_of(holder, name)
        if (pointer != "" && !(pointer in is_type)) check_read(pointer, before, rest)
    }
}

# What a member is set to has a name; of a member that has a type the compiler sees that anything else has it, too.
function use_set(pointer, rest,   found, word) {
    sub(/^ = /, "", rest)
    sub(/[,;}].*/, "", rest)
    found = rest == "NULL" || pointer in is_type
    while (match(rest, /[A-Za-z_][A-Za-z_0-9]*/)) {
        word = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        if (owner(word) == "" || (word in is_local) || rest ~ /^\(/) continue
        put(pointer, word)
        is_set_here[file, word] = row
        found = 1
    }
    if (!found) wrong(pointer ": is set to what is no function's name")
}

# A member's value is asked for whether there is one, and for nothing else.
function check_read(pointer, before, rest) {
    if (rest ~ /^ (\?|&&|\|\||!=|==)/ || before ~ /![A-Za-z_0-9.>-]*$/) return
    if (before ~ /(if \(|&& |\|\| )[A-Za-z_0-9.>-]*$/ && rest ~ /^[);]/) return
    wrong(pointer ": its value goes elsewhere: declare a type of functions for it")
}

function use_call(name) {
    if (owner(name) == "" && ((file, name) in variable)) put_call(variable[file, name])
}

# A function's name without a call: it is set to a member, or has a type.
function use_function(before, name) {
    if (owner(name) == "" || is_set_here[file, name] == row || before ~ /((struct|enum|union) |LIM_AGREES\(|\(\*)$/) return
    if (!((owner(name), name) in type_of_function)) wrong(name ": its address is taken, and nobody says as what: declare it by a type of functions")
}

END {
    for (file = 1; file <= file_count; file++)
        for (row = 1; row <= lines[file]; row++) read_declarations(line[file, row])
    for (file = 1; file <= file_count; file++)
        for (row = 1; row <= lines[file]; row++) read_types(line[file, row])
    for (file = 1; file <= file_count; file++)
        for (row = 1; row <= lines[file]; row++) read_uses(line[file, row])
    for (pointer in is_set) {
        if ((pointer in called_at) || pointer in is_type) continue
        print pointer ": is set, and nobody calls it" > "/dev/stderr"
        failed = 1
    }
    for (pointer in called_at) {
        if (pointer in is_set || pointer in is_programs) continue
        print called_at[pointer] ": calls through " pointer ", and nothing is set to it" > "/dev/stderr"
        failed = 1
    }
    exit failed
}
