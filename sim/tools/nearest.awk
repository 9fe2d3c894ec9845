# SPDX-License-Identifier: MIT
#
# What somebody may have meant: awk -f sim/tools/nearest.awk GIVEN WORD... Prints `= WORD` where they differ in capitals at
# most; `~ WORD` where few letters are missing, too many, others or exchanged; else nothing. base/choice.c judges alike.
function least(a, b) { return a < b ? a : b }

# How many such letters there are, of words in small letters.
function distance(a, b,    i, k, d, is_other) {
    for (i = 0; i <= length(a); i++) d[i, 0] = i
    for (k = 0; k <= length(b); k++) d[0, k] = k
    for (i = 1; i <= length(a); i++)
        for (k = 1; k <= length(b); k++) {
            is_other = substr(a, i, 1) != substr(b, k, 1)
            d[i, k] = least(least(d[i - 1, k], d[i, k - 1]) + 1, d[i - 1, k - 1] + is_other)
            if (i > 1 && k > 1 && substr(a, i, 1) == substr(b, k - 1, 1) && substr(a, i - 1, 1) == substr(b, k, 1))
                d[i, k] = least(d[i, k], d[i - 2, k - 2] + 1)
        }
    return d[length(a), length(b)]
}

BEGIN {
    given = tolower(ARGV[1])
    most = least(int(length(given) / 3), 3)
    for (i = 2; i < ARGC; i++) {
        away = distance(given, tolower(ARGV[i]))
        if (away <= most && (nearest == "" || away < nearest_away)) {
            nearest = ARGV[i]
            nearest_away = away
        }
    }
    if (nearest != "") print (nearest_away ? "~" : "=") " " nearest
}
