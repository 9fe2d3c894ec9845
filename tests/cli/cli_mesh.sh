# SPDX-License-Identifier: MIT
#
# Meshes without a tree, from the command line: models are drawn as right as their method promises, whatever their
# vertices; files keep the scene; what a mesh does not draw is refused; where the compiler takes one, it says why.
. tests/tap.sh

limner=$BUILD/limner

says() { # PATTERN
    cat "$work/said"
    grep -qE "$1" "$work/said"
}

# wrong MODEL MOST OPTION...: percent of all pixels of an orbit that show another face than the reference
wrong() {
    model=$1 most=$2
    shift 2
    "$limner" render "$model" --size 160x120 --frames 8 --compare "$@" >"$work/said" 2>&1 || { cat "$work/said"; return 1; }
    awk -v most="$most" '/^compared/ { print; seen = 1; sub(/.*wrong /, ""); is_wrong = $1 + 0 > most } END { exit !seen || is_wrong }' "$work/said"
}

refused() { # REASON COMMAND...
    reason=$1
    shift
    "$limner" "$@" >/dev/null 2>"$work/said" && return 1
    [ "$(wc -l <"$work/said")" -eq 1 ] && says "$reason"
}

awk -v n=40 -f tests/ball.awk >"$work/ball.obj"

# Two boxes through each other, which no order of whole triangles gets right.
cross() {
    awk 'BEGIN {
        split("3 0.5 0.5 0.5 3 0.4", half)
        for (b = 0; b < 2; b++) for (i = 0; i < 8; i++)
            print "v", (i % 2 * 2 - 1) * half[3 * b + 1], (int(i / 2) % 2 * 2 - 1) * half[3 * b + 2], (int(i / 4) * 2 - 1) * half[3 * b + 3]
        n = split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", corner)
        for (b = 0; b < 2; b++) for (i = 1; i <= n; i += 4)
            print "f", 8 * b + corner[i], 8 * b + corner[i + 1], 8 * b + corner[i + 2], 8 * b + corner[i + 3]
    }'
}
cross >"$work/cross.obj"

# The same, twenty times as large, and a small thing so far behind the eye that the eye is within the scene's bounds.
around() {
    awk '{ if ($1 == "v") print "v", $2 * 20, $3 * 20, $4 * 20; else print } END {
        print "v 300 200 200\nv 302 200 200\nv 300 202 200"
        print "f 17 18 19"
    }' "$work/cross.obj"
}
around >"$work/around.obj"
awk 'BEGIN { for (i = 0; i < 8; i++) print 110 + 2 * i, 40 - 8 * i, 80 - 18 * i, 0, 0, 0 }' >"$work/around.cam"

# N cubes of 0.2 to 1 m, turned anyhow, many of them through others.
heap() { # N
    awk -v n="$1" '
        function random() { state = (state * 16807) % 2147483647; return state / 2147483647 }
        function turned(x, y, z, i,    u, v, w) { # by three angles
            u = x * cos(a) - y * sin(a); v = x * sin(a) + y * cos(a)
            w = v * sin(b) + z * cos(b); v = v * cos(b) - z * sin(b)
            return i == 1 ? v : i == 0 ? u * cos(c) + w * sin(c) : w * cos(c) - u * sin(c)
        }
        BEGIN {
            state = 4711
            count = split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", corner)
            for (k = 0; k < n; k++) {
                half = 0.1 + 0.4 * random(); a = 7 * random(); b = 7 * random(); c = 7 * random()
                for (i = 0; i < 3; i++) at[i] = (random() + random() + random() - 1.5) * n ^ (1 / 3) / 2
                for (i = 0; i < 8; i++) {
                    x = (i % 2 * 2 - 1) * half; y = (int(i / 2) % 2 * 2 - 1) * half; z = (int(i / 4) * 2 - 1) * half
                    print "v", at[0] + turned(x, y, z, 0), at[1] + turned(x, y, z, 1), at[2] + turned(x, y, z, 2)
                }
                for (i = 1; i <= count; i += 4)
                    print "f", 8 * k + corner[i], 8 * k + corner[i + 1], 8 * k + corner[i + 2], 8 * k + corner[i + 3]
            }
        }'
}
heap 120 >"$work/heap.obj"

# Also along faces, where a few triangles without depth do most harm.
heap_is_right() {
    wrong "$work/heap.obj" 0.05 --method mesh-depth && "$limner" compile "$work/heap.obj" --method mesh-depth -o "$work/heap" --report >"$work/said" &&
        says 'wrong pixels, grazing views' && awk '/wrong pixels, (predicted|grazing)/ { n++; for (i = 2; i <= NF; i++) if ($i == "%," && $(i - 1) > 0.05) bad = 1 }
            END { exit bad || n != 2 }' "$work/said"
}

# A spider's legs: most triangles need depth near the eye, a tenth of them in all views. The others paint without.
few_have_depth() {
    "$limner" compile "$assimp/OBJ/spider.obj" --method mesh-depth -o "$work/spider" --report >"$work/said" &&
        awk '{ print } /triangles with depth/ { deep = $NF } END { exit !(deep > 0 && deep < 1312 / 4) }' "$work/said"
}

passes_through() { # MODEL MOST OPTION...: it is wrong by more
    ! wrong "$@" && grep -q '^compared' "$work/said"
}

same_frames() { # METHOD: from the model and from the file, one by one
    "$limner" compile "$work/ball.obj" --method "$1" -o "$work/bumps" >/dev/null &&
        "$limner" render "$work/ball.obj" --method "$1" --size 96x96 --frames 4 --write-hashes "$work/model.hashes" &&
        "$limner" render "$work/bumps.lim" --method "$1" --size 96x96 --frames 4 --write-hashes "$work/file.hashes" &&
        cmp "$work/model.hashes" "$work/file.hashes"
}

a_c_compiler_takes_it() { # METHOD
    "$limner" compile "$work/ball.obj" --method "$1" -o "$work/bumps" >/dev/null &&
        (cd "$work" && ${CC:-gcc} -std=c11 -Wall -Wextra -Werror -DLIM_CONFIG='"bumps.h"' -I. "-I$OLDPWD/firmware" -c bumps.c -o bumps.o) &&
        grep -q 'an approximate order' "$work/bumps.h" && ! grep -q exact "$work/bumps.h"
}

few_bytes() {
    "$limner" compile "$work/ball.obj" --method mesh --report >"$work/said" || return 1
    cat "$work/said"
    awk '/^  in all/ { exit !($NF <= 13) }' "$work/said"
}

# No more than what such a mesh takes, tried by name; the tree takes less than that.
not_tried() { # MODEL
    "$limner" compile "$1" --report >"$work/said" && "$limner" compile "$1" --method mesh --report >"$work/by_name" || return 1
    grep -A 4 'not drawn as a mesh' "$work/said" && grep '^  instructions a frame' "$work/by_name" && ! grep 'by distance' "$work/said" || return 1
    awk '/^    by the tree/ { tree = $4 } / for its vertices alone/ { least = $4 } /^  instructions a frame/ { all = $4 }
        END { exit !(tree > 0 && tree < least && least < all) }' "$work/said" "$work/by_name"
}

quick() { # 100,000 triangles
    awk -v n=224 -f tests/ball.awk >"$work/large.obj"
    timeout 60 "$limner" render "$work/large.obj" --method mesh-depth --size 96x96 --frames 1 -o "$work/large.png"
}

tap_check "a teapot by depth is right" wrong sim/scenes/teapot.obj 0.06 --method mesh-depth
tap_check "a teapot by distance nearly is" wrong sim/scenes/teapot.obj 0.3 --method mesh
tap_check "a ball by distance is right" wrong "$work/ball.obj" 0.08 --method mesh
tap_check "so it is in fine" wrong "$work/ball.obj" 0.06 --method mesh-depth --precision fine
tap_check "and in exact" wrong "$work/ball.obj" 0.06 --method mesh-depth --precision exact
tap_check "boxes through each other are right by depth" wrong "$work/cross.obj" 0.05 --method mesh-depth
tap_check "so is a heap of cubes through each other" heap_is_right
assimp=/usr/share/assimp/models
if [ -d $assimp ]; then
    tap_check "of a spider few triangles have depth" few_have_depth
else
    tap_skip "of a spider few triangles have depth" "assimp-testmodels is not installed"
fi
tap_check "and wrong by distance: what is approximate may be" passes_through "$work/cross.obj" 0.05 --method mesh
tap_check "far from an eye within the bounds they are right by depth, too" wrong "$work/around.obj" 0.05 --method mesh-depth --camera "$work/around.cam"
tap_check "no mesh is tried where its vertices alone cost more" not_tried sim/scenes/rooms.obj
tap_check "rooms from within nearly are" wrong sim/scenes/rooms.obj 0.07 --method mesh-depth --camera sim/scenes/rooms.cam
for method in mesh mesh-depth; do
    tap_check "a file draws what its model does, $method" same_frames $method
    tap_check "its C is compiled, and not called exact, $method" a_c_compiler_takes_it $method
done
tap_check "13 bytes a triangle, or fewer" few_bytes
tap_check "100,000 triangles take no minute" quick

textured=sim/scenes/mapped/teapottex.obj
few_bytes_textured() {
    "$limner" compile "$textured" --method mesh --report >"$work/said" || return 1
    cat "$work/said"
    awk '/^  (texels|palettes)/ { less += $(NF - 1) } /^  in all/ { exit !(($(NF - 1) - less) / 992 <= 18) }' "$work/said"
}
same_textured() { # METHOD
    "$limner" compile "$textured" --method "$1" -o "$work/bumps" >/dev/null &&
        "$limner" render "$textured" --method "$1" --size 96x96 --frames 4 --write-hashes "$work/model.hashes" &&
        "$limner" render "$work/bumps.lim" --method "$1" --size 96x96 --frames 4 --write-hashes "$work/file.hashes" &&
        cmp "$work/model.hashes" "$work/file.hashes"
}
textured_c() {
    "$limner" compile "$textured" --method "$1" -o "$work/bumps" >/dev/null &&
        (cd "$work" && ${CC:-gcc} -std=c11 -Wall -Wextra -Werror -DLIM_CONFIG='"bumps.h"' -I. "-I$OLDPWD/firmware" -c bumps.c -o bumps.o)
}
tap_check "a textured teapot by depth is right" wrong $textured 0.06 --method mesh-depth
for method in mesh mesh-depth; do
    tap_check "a file draws what its textured model does, $method" same_textured $method
    tap_check "its C is compiled, $method" textured_c $method
done
tap_check "18 bytes a textured triangle, or fewer, beside the pictures" few_bytes_textured

"$limner" compile "$work/ball.obj" --method mesh -o "$work/mesh" >/dev/null
"$limner" compile "$work/ball.obj" --method nearest -o "$work/tree" >/dev/null
drawn_by_itself() { # SCENE METHOD
    "$limner" render "$1.lim" --frames 4 --size 64x64 --method "$2" --write-hashes "$work/named" &&
        "$limner" render "$1.lim" --frames 4 --size 64x64 --write-hashes "$work/unnamed" && diff "$work/named" "$work/unnamed"
}
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib glass.mtl\nusemtl glass\nf 1 2 3\n' >"$work/glass.obj"
printf 'newmtl glass\nKd 1 1 1\nd 0.5\n' >"$work/glass.mtl"
cp tests/models/quarters.obj tests/models/quarters.mtl tests/models/quarters.png "$work/"
for option in --wireframe --antialias --delta --fill; do
    tap_check "$option is refused" refused "^limner: .*--method mesh: $option is drawn nearest first" compile "$work/ball.obj" --method mesh $option -o "$work/x"
done
tap_check "--framebuffer is refused" refused 'it draws line by line' compile "$work/ball.obj" --method mesh-depth --framebuffer -o "$work/x"
tap_check "portals are refused" refused 'a mesh has no cells' compile "$work/ball.obj" --method mesh --portals on -o "$work/x"
tap_check "a tree is refused" refused 'that method has a tree of its own' compile "$work/ball.obj" --method mesh --tree bsp -o "$work/x"
tap_check "a mesh by a method of trees is refused" refused 'it draws no meshes' compile "$work/ball.obj" --method nearest --tree mesh -o "$work/x"
tap_check "glass is refused, by its face" refused 'face 1: as a mesh, transparent faces are not drawn' render "$work/glass.obj" --method mesh
sed 's/^vt .*/vt 0 0/; 1,/^vt /s/^vt .*/vt 30000 0/' "$work/quarters.obj" >"$work/often.obj"
tap_check "a texture that repeats too often is refused, by its face" refused 'face [0-9]*: as a mesh, its texture repeats too often' render "$work/often.obj" --method mesh
tap_check "a file of a mesh is drawn as one" drawn_by_itself "$work/mesh" mesh
"$limner" compile sim/scenes/knot.obj --method mesh-depth -o "$work/deep" >/dev/null
tap_check "by depth where triangles have it" drawn_by_itself "$work/deep" mesh-depth
"$limner" compile sim/scenes/knot.obj --method newell -o "$work/set" >/dev/null
tap_check "and a set by the depth sort" drawn_by_itself "$work/set" newell
"$limner" compile sim/scenes/knot.obj --method depth -o "$work/farthest" >/dev/null
tap_check "and one by farthest points so" drawn_by_itself "$work/farthest" depth
tap_check "nor what no mesh is drawn with" refused 'a mesh has no tree; draw it with --method mesh or mesh-depth' render "$work/mesh.lim" --wireframe
tap_check "a file of a mesh names the methods that draw it" refused 'a mesh has no tree; draw it with --method mesh or mesh-depth' render "$work/mesh.lim" --method nearest
tap_check "a file with a tree is none" refused 'has a tree; --method mesh draws meshes, give the model$' render "$work/tree.lim" --method mesh
tap_check "nor is one for newell" refused 'a mesh has no tree' render "$work/mesh.lim" --method newell
tap_done
