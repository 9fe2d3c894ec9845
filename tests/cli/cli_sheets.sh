# SPDX-License-Identifier: MIT
#
# Decals, posters and sheets, as users meet them: over what they lie on in every profile, tree and method, on what moves, with
# textures, and a note where faces share a plane. tests/unit/sim/test_sheets.c has the many.
. tests/tap.sh

limner=$BUILD/limner

# The floor's half-side, the decal's height; which of the two comes first in the file.
decal() { # HALF HEIGHT FLOOR-FIRST
    awk -v half="$1" -v height="$2" -v first="$3" 'BEGIN {
        print "mtllib sheets.mtl"
        print "v", -half, -half, 0 "\nv", half, -half, 0 "\nv", half, half, 0 "\nv", -half, half, 0
        print "v -.4 -.4", height "\nv .4 -.4", height "\nv .4 .4", height "\nv -.4 .4", height
        print "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1"
        ground = "usemtl ground\nf 1/1 2/2 3/3 4/4"
        poster = "usemtl poster\nf 5/1 6/2 7/3 8/4"
        print first ? ground "\n" poster : poster "\n" ground }'
}
cat >"$work/sheets.mtl" <<'END'
newmtl ground
Kd 1 0 0
newmtl poster
Kd 0 1 0
END
cat >"$work/decal.cam" <<'END'
0 0 3 0 0 0
1 1 5 0 0 0
END

# In the middle of the first picture: face numbers of --ids have four bytes.
shows() { # FACE MODEL OPTION...
    face=$1 model=$2
    shift 2
    "$limner" render "$model" --camera "$work/decal.cam" --size 64x64 --ids "$work/ids" "$@" 2>"$work/notes" &&
        [ "$(od -An -tu4 -j $((4 * (32 * 64 + 32))) -N 4 "$work/ids" | tr -d ' ')" -eq "$face" ]
}
everywhere() { # FACE MODEL
    for precision in draft fast fine exact; do
        for how in '--tree bsp' '--tree clusters' '--tree axis' '--tree octree' '--method painter' '--method scanline' \
            '--coordinates 32'; do
            # shellcheck disable=SC2086 # words
            shows "$1" "$2" --precision $precision $how || { echo "$precision $how" && return 1; }
        done
    done
}
decal 100 .001 1 >"$work/over.obj"
tap_check "a decal 1 mm above a floor of 200 m" everywhere 2 "$work/over.obj"
decal 100 .001 0 >"$work/over.obj"
tap_check "and where it comes first in the file" everywhere 1 "$work/over.obj"
decal 1000 .01 1 >"$work/over.obj"
tap_check "1 cm above a floor of 2 km" everywhere 2 "$work/over.obj"
decal 100 -.001 1 >"$work/under.obj"
tap_check "1 mm below it is not seen" everywhere 1 "$work/under.obj"
decal 100 0 1 >"$work/level.obj"
tap_check "in its plane the later in the file is seen" everywhere 2 "$work/level.obj"
decal 100 0 0 >"$work/level.obj"
tap_check "whichever it is" everywhere 2 "$work/level.obj"

notes() { # PATTERN COMMAND...
    pattern=$1
    shift
    "$limner" "$@" >"$work/said" 2>"$work/notes" && cat "$work/notes" && [ "$(grep -c -- "$pattern" "$work/notes")" -eq 1 ]
}
tap_check "a note counts what is covered" notes \
    '^limner: note: 1 faces are covered, in part or whole, by later faces of the file in the same plane' \
    render "$work/level.obj" --camera "$work/decal.cam" --size 16x16
silent() { "$limner" render "$1" --camera "$work/decal.cam" --size 16x16 2>"$work/notes" && ! grep covered "$work/notes"; }
tap_check "and nothing where nothing is" silent "$work/over.obj"
tap_check "the report counts it, too" sh -c "'$limner' compile '$work/level.obj' --report | grep 'covered by a later, coplanar  *1$'"

for method in newell depth mesh mesh-depth; do
    tap_check "a note says that $method does not order them" notes \
        "^limner: note: 2 faces lie in a plane with others, or nearly: --method $method does not order them; --method nearest " \
        render "$work/over.obj" --camera "$work/decal.cam" --size 16x16 --method "$method"
done
tap_check "and nothing of what no other is near to" sh -c "'$limner' render sim/scenes/icosahedron.obj --size 16x16 \
    --frames 1 --method newell 2>&1 | { ! grep 'does not order'; }"

# A textured poster in the wall's plane: its green half is on the left.
textured() {
    python3 - "$work/poster.png" <<'END' || return 1
import struct, sys, zlib
def part(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
row = b"\0" + b"\0\xff\0" * 4 + b"\0\0\xff" * 4
open(sys.argv[1], "wb").write(b"\x89PNG\r\n\x1a\n" + part(b"IHDR", struct.pack(">IIBBBBB", 8, 8, 8, 2, 0, 0, 0)) +
                              part(b"IDAT", zlib.compress(row * 8)) + part(b"IEND", b""))
END
    echo 'map_Kd poster.png' >>"$work/sheets.mtl" && sed -i 's/^Kd 0 1 0/Kd 1 1 1/' "$work/sheets.mtl"
    for height in 0 .001; do
        decal 100 $height 1 >"$work/textured.obj"
        shows 2 "$work/textured.obj" && "$limner" render "$work/textured.obj" --camera "$work/decal.cam" --size 64x64 --compare \
            >"$work/said" 2>&1 && tail -n 1 "$work/said" | grep 'wrong 0\.00' || return 1
    done
}
tap_check "a textured poster, above a wall and in its plane" textured

# A plate that slides, a decal 1 mm over it, and one in its plane; the ground is far below.
movers() {
    python3 - "$work/moving.gltf" <<'END' || return 1
import base64, json, struct, sys
def quad(half_x, half_z, y):
    return [(-half_x, y, -half_z), (-half_x, y, half_z), (half_x, y, half_z), (half_x, y, -half_z)]
data, views, accessors, meshes = b"", [], [], []
def add(body, accessor):
    global data
    views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(body)})
    accessors.append(dict(accessor, bufferView=len(views) - 1))
    data += body + b"\0" * (-len(body) % 4)
    return len(accessors) - 1
def primitive(corners, material):
    at = add(b"".join(struct.pack("<3f", *c) for c in corners), {"componentType": 5126, "count": 4, "type": "VEC3",
        "min": [min(c[k] for c in corners) for k in range(3)], "max": [max(c[k] for c in corners) for k in range(3)]})
    faces = add(struct.pack("<6H", 0, 1, 2, 0, 2, 3), {"componentType": 5123, "count": 6, "type": "SCALAR"})
    return {"attributes": {"POSITION": at}, "indices": faces, "material": material}
meshes.append({"primitives": [primitive(quad(100, 100, -5), 0)]})
meshes.append({"primitives": [primitive(quad(50, 50, 0), 1), primitive(quad(.4, .4, .001), 2)]})
times = add(struct.pack("<2f", 0, 1), {"componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]})
places = add(struct.pack("<6f", 0, 0, 0, 0, 0, .05), {"componentType": 5126, "count": 2, "type": "VEC3"})
colours = [[.5, .5, .5, 1], [1, 0, 0, 1], [0, 1, 0, 1]]
json.dump({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0}, {"mesh": 1, "name": "plate"}], "meshes": meshes,
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": c}} for c in colours],
    "animations": [{"samplers": [{"input": times, "output": places}],
                    "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}]}],
    "bufferViews": views, "accessors": accessors,
    "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]},
    open(sys.argv[1], "w"))
END
    echo '0 3 0.5 0 0 0 @0.5' >"$work/decal.cam"
    for precision in draft fast fine exact; do # faces 3 and 4 are the plate's, 5 and 6 the decal's
        { shows 5 "$work/moving.gltf" --precision $precision || shows 6 "$work/moving.gltf" --precision $precision; } || return 1
    done
}
tap_check "a decal on what moves" movers
tap_done
