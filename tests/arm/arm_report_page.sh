# SPDX-License-Identifier: MIT
#
# With --core, `limner report` has the instructions that `limner measure` counts, of each precision and each file of the
# renderer; and `limner worst` counts what it found.
. tests/tap.sh

limner=$BUILD/limner
model=sim/scenes/icosahedron.obj
printf '0 0.2 3 0 0 0\n2 1 2 0 0 0\n' >"$work/two.cam"

text_of() { tr '\n' ' ' <"$1" | sed 's/<\/tr>/\n/g; s/<\/p>/\n/g' | sed 's/<[^>]*>/ /g; s/&#8239;//g; s/  */ /g; s/^ //; s/ $//'; }

pages() {
    "$limner" report $model --method convex --size 64x64 --camera "$work/two.cam" --tries 20 --core m0plus -o "$work/page.html" &&
        "$limner" measure $model --method convex --size 64x64 --camera "$work/two.cam" --core m0plus -o "$work/measured" && text_of "$work/page.html" >"$work/text"
}
tap_check "a page with counts" pages

# measure.csv and stages.csv have names of columns in their first lines.
field() { # FILE NAME KEY...: of the row that has all the keys
    file=$1 name=$2
    shift 2
    awk -F , -v name="$name" -v keys="$*" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) at = i; count = split(keys, key, " "); next }
        { found = 0; for (k = 1; k <= count; k++) for (i = 1; i <= NF; i++) if ($i == key[k]) { found++; break } }
        found == count { printf "%.0f\n", $at }' "$file"
}
rows_are_measures() {
    for name in draft fast fine exact; do
        count=$(field "$work/measured/measure.csv" instructions $name m0plus)
        [ -n "$count" ] && grep -E "^[0-9] $name .* $count [0-9]+ [0-9]+ " "$work/text" || { echo "$name: $count"; return 1; }
    done
}
tap_check "each precision takes what measure counts" rows_are_measures
stages_are_measures() {
    for stage in project convex; do
        count=$(field "$work/measured/stages.csv" instructions fast m0plus $stage)
        [ -n "$count" ] && grep -E "^$stage $count " "$work/text" || { echo "$stage: $count"; return 1; }
    done
}
tap_check "and each file of the renderer" stages_are_measures
worst_is_counted() {
    "$limner" worst $model --size 64x64 --tries 20 --core m0plus >"$work/said" && cat "$work/said" &&
        grep -E '^Cortex-M0\+: [0-9]+ instructions where it costs most, counted; [0-9]+ in the mean of 16 random cameras, [0-9]+ at most$' "$work/said"
}
tap_check "worst counts what it found" worst_is_counted
tap_done
