#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Fits what sim/render/frame_cost.c predicts by to what the renderer costs now: BUILD=build sh sim/tools/fit_frame_cost.sh prints all
# of its tables, and by how much the prediction is off for each scene, size and tree. FIT_DATA=FILE keeps the counts,
# and takes them from there the next time.
set -eu

: "${BUILD:=build}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
data=${FIT_DATA:-$work/data}

# Stages whose work the same counters explain.
group_of='
    function group_of(stage) {
        if (stage ~ /^(walk|eye|orientation|mesh)$/) return "tree"
        if (stage == "cull") return "box"
        if (stage ~ /^(view|rows|project|transform|angle)$/) return "front"
        if (stage ~ /^(mesh_)?clip$/) return "clip"
        return "lines"
    }'

# A line: METHOD SCENE-SIZE-TREE-SPLITTER, five groups of instructions, thirteen counters.
count() { # METHOD SCENE SIZE TREE SPLITTER [CAMERAS]: an eighth of its own path, or these
    folder=sim/scenes
    [ -s "$folder/$2.obj" ] || folder=$work
    awk 'n++ % 8 == 0' "$folder/$2.cam" >"$work/cam"
    cameras=${6:-$work/cam}
    "$BUILD/limner" measure "$folder/$2.obj" --camera "$cameras" --size "$3" --tree "$4" --splitter "$5" --method "$1" \
        --precision fast --core m0plus -o "$work/out" >/dev/null 2>"$work/said" || { cat "$work/said" >&2; return 1; }
    "$BUILD/limner" render "$folder/$2.obj" --camera "$cameras" --size "$3" --tree "$4" --splitter "$5" --method "$1" \
        --stats >"$work/stats"
    awk -F , "$group_of"'
        NR > 1 { sum[group_of($4)] += $5 }
        END { printf "%s %d %d %d %d %d ", name, sum["tree"], sum["box"], sum["front"], sum["clip"], sum["lines"] }' \
        name="$1 $2-$3-$4-$5${6:+-$6}" "$work/out/stages.csv"
    awk -v w_px="${3%x*}" -v h_px="${3#*x}" '
        $1 == "frame" { for (i = 1; i <= NF; i++) column[$i] = i }
        $1 ~ /^[0-9]+$/ { crossing += $column["seen"] * $column["lines"] / h_px; frames++ } # a product: frame by frame
        $1 == "mean" {
            print $column["nodes"], $column["records"], $column["boxes"], $column["vertices"], $column["polygons"],
                $column["clipped"], $column["seen"], $column["lines"], $column["gaps"], h_px,
                $column["overdraw"] * w_px * h_px, crossing / frames, $column["deep_px"]
        }' "$work/stats"
}

[ -s "$data" ] || for method in nearest scanline; do
    for scene in rooms rooms-tilted teapot knot; do
        for tree in bsp clusters axis octree; do
            count $method $scene 240x240 $tree auto
        done
        count $method $scene 128x64 bsp auto
    done
    count $method teapot 240x240 bsp first # twice as many nodes
done >"$data"
# Meshes: what they are for, and little of what they are not for. The numbers of a splitter mean nothing.
for triangles in 500 2000 4000; do
    "$BUILD/generate_scale" mesh $triangles "$work"
done
grep -q '^mesh' "$data" || for method in mesh mesh-depth; do
    for scene in teapot knot mesh500 mesh2000 mesh4000; do
        for size in 240x240 128x64; do
            count $method $scene $size mesh auto
        done
    done
    for scene in teapot mesh500 mesh2000 mesh4000; do count $method $scene 240x240 mesh auto random:3:8; done
done >>"$data"

# Least squares by descent along one factor at a time, which can be kept at 0 or above; several times, what was far off
# weighing more the next time: the worst of the errors is what counts.
fit() { # METHOD TITLE
    awk -v method="$1" -v title="$2" '
        BEGIN {
            split("node record box vertex polygon clipped seen line gap screen_line pixel crossing deep", name)
            split("1 2;3;4 5;6;5 7 8 9 10 11 12 13", counters_of, ";")
        }
        $1 ~ "^" method {
            rows++
            label[rows] = $1 " " $2
            for (g = 1; g <= 5; g++) { counted[rows, g] = $(2 + g); all[rows] += $(2 + g) }
            for (k = 1; k <= 13; k++) counter[rows, k] = $(7 + k)
        }
        function explain(g,   ks, n, a, b, i, j, r, pass, factor, weight) {
            n = split(counters_of[g], ks, " ")
            for (i = 1; i <= n; i++) {
                b[i] = factor[i] = 0
                for (j = 1; j <= n; j++) a[i, j] = 0
                for (r = 1; r <= rows; r++) {
                    weight = weighs[r] / (all[r] * all[r])
                    b[i] += weight * counter[r, ks[i]] * counted[r, g]
                    for (j = 1; j <= n; j++) a[i, j] += weight * counter[r, ks[i]] * counter[r, ks[j]]
                }
            }
            for (pass = 0; pass < 20000; pass++)
                for (i = 1; i <= n; i++) {
                    if (!a[i, i]) continue
                    r = b[i]
                    for (j = 1; j <= n; j++) if (j != i) r -= a[i, j] * factor[j]
                    factor[i] = r > 0 ? r / a[i, i] : 0
                }
            for (i = 1; i <= n; i++) result[ks[i]] += factor[i]
        }
        function predicted(r,   k, sum) {
            for (k = 1; k <= 13; k++) sum += result[k] * counter[r, k]
            return sum
        }
        function weigh(   r, off, most, sum) {
            for (r = 1; r <= rows; r++) {
                off[r] = predicted(r) / all[r] - 1
                if (off[r] < 0) off[r] = -off[r]
                if (off[r] > most) most = off[r]
            }
            for (r = 1; r <= rows; r++) sum += weighs[r] *= 0.2 + off[r] / most
            for (r = 1; r <= rows; r++) weighs[r] *= rows / sum
        }
        END {
            for (r = 1; r <= rows; r++) weighs[r] = 1
            for (times = 1; times <= 4; times++) {
                if (times > 1) weigh()
                for (k = 1; k <= 13; k++) result[k] = 0
                for (g = 1; g <= 5; g++) explain(g)
            }
            printf "static const struct frame_cost %s = {", title
            for (k = 1; k <= 13; k++) {
                result[k] = sprintf(k >= 11 ? "%.2f" : "%.0f", result[k])
                printf "%s.%s = %s", (k > 1 ? ", " : ""), name[k], result[k]
            }
            print "};"
            for (r = 1; r <= rows; r++) {
                printf "    %-42s counted %8d, off by %5.1f %%\n", label[r], all[r], (predicted(r) / all[r] - 1) * 100
            }
        }' "$data"
}

fit nearest NEAREST_FIRST
fit scanline SCANLINE
fit mesh MESH # both orders: a mesh by depth is one by distance but for what is compared
