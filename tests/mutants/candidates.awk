# SPDX-License-Identifier: MIT
#
# Lists the mutants of C files, one a line, divided by tabs: FILE LINE COLUMN LENGTH OPERATOR TEXT. The TEXT takes the
# place of LENGTH characters from the COLUMN on. Comments, strings, the preprocessor's lines, static asserts, asserts
# and the attribute `format`, which makes no code, have none. The sources are laid out by clang-format, which the
# patterns rely on: a binary operator stands between spaces, a unary one next to its operand, and a statement begins a
# line.

function mutant(column, length_, operator, text) {
    if (text != substr(raw, column, length_))
        printf "%s\t%d\t%d\t%d\t%s\t%s\n", FILENAME, FNR, column, length_, operator, text
}

# Each match of `pattern`, whose text begins with `skip` characters that stay, becomes `text`.
function replace_each(pattern, skip, length_, operator, text,    at, rest) {
    at = 0
    rest = code
    while (match(rest, pattern)) {
        mutant(at + RSTART + skip, length_, operator, text)
        at += RSTART + skip
        rest = substr(code, at + 1)
    }
}

function swap_binary(one, other, operator) {
    replace_fixed(" " one " ", 1, length(one), operator, other)
}

# The same of a relation, but where it chooses the smaller or larger of what it compares: of equals either will do.
function swap_bound(one, other,    at, from, before, after, a, b) {
    from = 1
    while (at = index(substr(code, from), " " one " ")) {
        from += at
        before = substr(code, 1, from - 2)
        after = substr(code, from + length(one) + 1)
        a = match(before, /[A-Za-z0-9_>.-]+$/) ? substr(before, RSTART) : ""
        b = match(after, /^[A-Za-z0-9_>.-]+/) ? substr(after, 1, RLENGTH) : ""
        after = substr(after, length(b) + 1)
        if (a != "" && b != "" && before !~ /[-+*\/&|] *[A-Za-z0-9_>.-]+$/ && (after ~ /^ \? [^ ]+ : [^ ;,)]+[;,)]/ || after ~ /^\) [^ ]+ = [^ ]+;$/)) {
            sub(/[;,)].*$/, "", after)
            if (after == " ? " a " : " b || after == " ? " b " : " a) continue
            after = substr(code, from + length(one) + 1 + length(b))
            if (after == ") " a " = " b ";" || after == ") " b " = " a ";") continue
        }
        mutant(from, length(one), "relation", other)
    }
}

function replace_fixed(text, skip, length_, operator, by,    at, from) {
    from = 1
    while (at = index(substr(code, from), text)) {
        mutant(from + at - 1 + skip, length_, operator, by)
        from += at
    }
}

# Where the bracket that stands at `from` is closed, or 0.
function closing(from,    depth, i, c) {
    for (i = from; i <= length(code); i++) {
        c = substr(code, i, 1)
        if (c ~ /[([{]/) depth++
        if (c ~ /[])}]/ && --depth == 0) return i
    }
    return 0
}

# Literals: one more, one less.
function literals(    at, rest, token, digits, suffix, before, value, base) {
    at = 0
    rest = code
    while (match(rest, /[0-9A-Za-z_.]+/)) {
        token = substr(rest, RSTART, RLENGTH)
        at += RSTART
        before = substr(code, 1, at - 1)
        if (token ~ /^(0[xX][0-9A-Fa-f]+|[0-9]+)[uUlL]*$/ && !is_size(before)) {
            match(token, /^(0[xX][0-9A-Fa-f]+|[0-9]+)/)
            digits = substr(token, 1, RLENGTH)
            suffix = substr(token, RLENGTH + 1)
            base = digits ~ /^0[xX]/ ? 16 : 10
            value = base == 16 ? from_hex(digits) : digits + 0
            mutant(at, length(token), "constant", in_base(value + 1, base) suffix)
            if (value > 0) mutant(at, length(token), "constant", in_base(value - 1, base) suffix)
        }
        at += length(token) - 1
        rest = substr(code, at + 1)
    }
}

# The size of an array that is declared: one more changes nothing, and one less is for the sanitizers.
function is_size(before) {
    return before ~ /[A-Za-z0-9_]+ \**[a-z_0-9]+(\[[^\]]*\])*\[$/ && before !~ /return [a-z_0-9]+\[$/
}

function from_hex(text,    value, i) {
    value = 0
    for (i = 3; i <= length(text); i++)
        value = value * 16 + index("0123456789abcdef", tolower(substr(text, i, 1))) - 1
    return value
}

function in_base(value, base,    text, digit) {
    if (base == 10) return sprintf("%.0f", value)
    text = ""
    do {
        digit = value % 16
        text = substr("0123456789ABCDEF", digit + 1, 1) text
        value = (value - digit) / 16
    } while (value > 0)
    return "0x" text
}

# if (x) and while (x): the opposite.
function negations(    at, rest, end, open) {
    at = 0
    rest = code
    while (match(rest, /(if|while) \(/)) {
        open = at + RSTART + RLENGTH - 1
        end = closing(open)
        if (end && substr(code, open - 3, 2) == "if" || end && code !~ /^ *\} while/) {
            mutant(open + 1, end - open - 1, "negation", "!(" substr(raw, open + 1, end - open - 1) ")")
        }
        at = open
        rest = substr(code, at + 1)
    }
    replace_each("[ (!]![a-z(]", 1, 1, "negation", "")
    replace_each("[ (]-[a-zA-Z(]", 1, 1, "sign", "")
    replace_each("[ (]~[a-zA-Z(]", 1, 1, "sign", "")
}

# c ? a : b becomes a, and b: a clamp is dropped. On one line, and not within another one.
function choices(    at, first, last, i, c, depth, colon, yes, no) {
    at = index(code, " ? ")
    if (!at || index(substr(code, at + 3), " ? ")) return
    depth = 0
    for (first = at; first > 1; first--) {
        c = substr(code, first, 1)
        if (c ~ /[])}]/) depth++
        if (c ~ /[([{]/ && depth-- == 0) break
        if (depth == 0 && (c == "," || substr(code, first, 3) ~ /^[ +*&|-]= $/ || substr(code, first - 6, 7) == "return "))
            break
    }
    if (first <= 1) return
    if (substr(code, first, 3) ~ /^.= $/) first += 2
    first++
    depth = colon = 0
    for (last = at + 3; last <= length(code); last++) {
        c = substr(code, last, 1)
        if (c ~ /[([{]/) depth++
        if (c ~ /[])}]/ && depth-- == 0) break
        if (depth == 0 && (c == "," || c == ";")) break
        if (depth == 0 && substr(code, last, 3) == " : ") colon = last
    }
    if (!colon || last > length(code)) return
    while (substr(code, first, 1) == " ") first++
    yes = substr(raw, at + 3, colon - at - 3)
    no = substr(raw, colon + 3, last - colon - 3)
    mutant(first, last - first, "choice", yes)
    mutant(first, last - first, "choice", no)
}

# f(a, b) becomes f(b, a), unless f(a, b) is f(b, a): products, the greater, what two rectangles share, whether two
# strings are equal.
function arguments(    at, rest, open, end, i, c, depth, comma, second) {
    if (code !~ /^ /) return # a function's head
    at = 0
    rest = code
    while (match(rest, /[a-z_0-9]\([^()]/)) {
        open = at + RSTART + 1
        at = open
        rest = substr(code, at + 1)
        end = closing(open)
        if (!end || substr(code, 1, open - 1) ~ /(^|[^a-z_])(if|for|while|switch|return|sizeof)$/) continue
        if (substr(code, 1, open - 1) ~ /(^|[^a-z_])(lim_mul_q30|mul_high_[a-z_]*s32|greater|smaller|intersection|is_same|strcmp)$/) continue
        depth = comma = second = 0
        for (i = open + 1; i < end; i++) {
            c = substr(code, i, 1)
            if (c ~ /[([{]/) depth++
            if (c ~ /[])}]/) depth--
            if (depth == 0 && c == ",") {
                if (comma) { second = i; break }
                comma = i
            }
        }
        if (!comma) continue
        if (!second) second = end
        mutant(open + 1, second - open - 1, "arguments", substr(raw, comma + 2, second - comma - 2) ", " \
            substr(raw, open + 1, comma - open - 1))
    }
}

# What a statement of one line does is not done.
function statements(    begins, value) {
    begins = match(code, /[^ ]/)
    if (!starts || code !~ /;$/ || begins == 1) return
    if (code ~ /^ +(break|continue);$/ || code ~ /^ +(else )?if \(.*\) .*;$/ || is_effect(substr(code, begins))) {
        if (code ~ /^ +else /) begins = begins + 5
        mutant(begins, length(code) - begins + 1, "statement", ";")
    }
}

function is_effect(text) {
    if (text ~ /^(return|break|continue|goto|case|default|else|do|while|for|if|static|const|struct|typedef|enum|union|extern)([^a-z_0-9]|$)/)
        return 0
    if (text ~ /^\(void\)/ || text ~ /^[a-z_0-9]+ \**[a-z_]/) return 0
    return text ~ /^[*(]*[a-z_].*( [-+*\/|&^%<>]*= |\(|\+\+|--)/
}

function results(    value) {
    if (!match(code, /return [^;]*;/)) return
    value = substr(code, RSTART + 7, RLENGTH - 8)
    if (value == "0" || value == "false")
        mutant(RSTART + 7, RLENGTH - 8, "result", value == "0" ? "1" : "true")
    else
        mutant(RSTART + 7, RLENGTH - 8, "result", value == "true" ? "false" : "0")
}

# Comments, strings and character literals become as many spaces or other characters: columns stay.
function blank(line,    i, c, two, out, quote) {
    out = ""
    quote = ""
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        two = substr(line, i, 2)
        if (in_comment) {
            if (two == "*/") { in_comment = 0; i++; out = out " " }
            out = out " "
        } else if (quote != "") {
            if (c == "\\") { i++; out = out "@" }
            if (c == quote) quote = ""
            out = out "@"
        } else if (two == "/*") {
            in_comment = 1
            i++
            out = out "  "
        } else if (two == "//") {
            break
        } else {
            if (c == "\"" || c == "'") { quote = c; c = "@" }
            out = out c
        }
    }
    sub(/ +$/, "", out)
    return out
}

# The attribute becomes other characters: columns stay.
function without_format(    at, end, i, covered) {
    while (at = index(code, "__attribute__((format(")) {
        end = closing(at + length("__attribute__"))
        if (!end) return
        covered = ""
        for (i = at; i <= end; i++)
            covered = covered "@"
        code = substr(code, 1, at - 1) covered substr(code, end + 1)
    }
}

FNR == 1 { in_comment = in_directive = in_assert = 0; starts = 1 }

{
    raw = $0
    code = blank(raw)
    if (in_directive || code ~ /^ *#/) {
        in_directive = raw ~ /\\$/
        next
    }
    if (in_assert || code ~ /(^|[^a-z_])(_Static_assert|static_assert|assert) *\(/) {
        in_assert = code !~ /;$/
        next
    }
    if (code ~ /^ *$/) next
    without_format()

    swap_bound("<", "<="); swap_bound("<=", "<")
    swap_bound(">", ">="); swap_bound(">=", ">")
    swap_binary("==", "!=", "relation"); swap_binary("!=", "==", "relation")
    swap_binary("<", ">", "relation"); swap_binary(">", "<", "relation")
    swap_binary("&&", "||", "logic"); swap_binary("||", "&&", "logic")
    swap_binary("+", "-", "arithmetic"); swap_binary("-", "+", "arithmetic")
    swap_binary("*", "/", "arithmetic"); swap_binary("/", "*", "arithmetic"); swap_binary("%", "*", "arithmetic")
    swap_binary("+=", "-=", "arithmetic"); swap_binary("-=", "+=", "arithmetic"); swap_binary("*=", "/=", "arithmetic")
    swap_binary("<<", ">>", "shift"); swap_binary(">>", "<<", "shift")
    swap_binary("<<=", ">>=", "shift"); swap_binary(">>=", "<<=", "shift")
    swap_binary("&", "|", "bits"); swap_binary("|", "&", "bits"); swap_binary("^", "&", "bits")
    swap_binary("&=", "|=", "bits"); swap_binary("|=", "&=", "bits"); swap_binary("^=", "|=", "bits")
    if (code !~ /^ *for \(/) {
        replace_fixed("++", 0, 2, "arithmetic", "--")
        replace_fixed("--", 0, 2, "arithmetic", "++")
    }
    literals()
    negations()
    choices()
    arguments()
    statements()
    results()
    starts = code ~ /([;{}:]|\)|else|do)$/
}
