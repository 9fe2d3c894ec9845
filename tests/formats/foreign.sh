# SPDX-License-Identifier: MIT
#
# What other programs write, and this project had not been shown before: as they mean it, or told in one line. The files
# are small ones of the same kinds as those of Blender, MeshLab, FreeCAD and gmsh.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
files=$(pwd)/tests/formats/gltf.py
export PYTHONDONTWRITEBYTECODE=1
cd "$work" || exit 1
printf '3 -6 5 2 1 1\n12 9 14 1 1 3\n' >both.cam

draws() { # MODEL OPTION...: hashes, and what is said
    timeout 60 "$limner" render "$@" --camera both.cam --size 64x64 --write-hashes "$1.hashes" 2>told || { cat told; return 1; }
}

says() { # MODEL PATTERN
    draws "$1" && cat told && grep -q -- "^limner: note: $2" told
}

refuses() { # MODEL WORDS
    "$limner" compile "$1" -o none >/dev/null 2>told && return 1
    cat told
    [ "$(wc -l <told)" = 1 ] && sed "s/gltf:1: /gltf: /" told | grep -qxF "limner: $1: $2" && [ ! -e none.h ]
}

# A box of 2, 3 and 4 metres, in words of AMF and of STL.
box() { # FORMAT
    awk -v format="$1" 'BEGIN {
        split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", corner)
        for (i = 0; i < 8; i++) { x[i + 1] = i % 2 * 2; y[i + 1] = int(i / 2) % 2 * 3; z[i + 1] = int(i / 4) * 4 }
        if (format == "amf") {
            print "<?xml version=\"1.0\"?><amf unit=\"meter\"><object id=\"0\"><mesh><vertices>"
            for (i = 1; i <= 8; i++) printf "<vertex><coordinates><x>%d</x><y>%d</y><z>%d</z></coordinates></vertex>\n", x[i], y[i], z[i]
            print "</vertices><volume>"
        } else print "solid box"
        for (f = 0; f < 6; f++) for (t = 1; t < 3; t++) {
            split(corner[4 * f + 1] " " corner[4 * f + t + 1] " " corner[4 * f + t + 2], c, " ")
            if (format == "amf") printf "<triangle><v1>%d</v1><v2>%d</v2><v3>%d</v3></triangle>\n", c[1] - 1, c[2] - 1, c[3] - 1
            else { print "facet normal 0 0 0\nouter loop"
                for (k = 1; k <= 3; k++) print "vertex", x[c[k]], y[c[k]], z[c[k]]
                print "endloop\nendfacet" }
        }
        print format == "amf" ? "</volume></mesh></object></amf>" : "endsolid"
    }'
}
box amf >box.amf
box stl >box.stl
stands_as_stl() {
    draws box.amf && draws box.stl --up z && cmp box.amf.hashes box.stl.hashes && ! { draws box.amf --up y && cmp -s box.amf.hashes box.stl.hashes; }
}
tap_check "AMF has z up, as other files for printers" stands_as_stl

corners='0 0 0 255 0 0 255
2 0 0 255 0 0 255
0 2 0 255 0 0 255'
printf 'COFF\n3 1 0\n%s\n3 0 1 2\n' "$corners" >plain.off
printf 'CSTOFF\n3 1 0\n%s\n3 0 1 2\n' "$(echo "$corners" | sed 's/$/ 0.5 0.5/')" >meshlab.off
off_alike() { draws plain.off --two-sided && draws meshlab.off --two-sided && cmp plain.off.hashes meshlab.off.hashes; }
tap_check "OFF with the letters of its first word in MeshLab's order" off_alike

printf '<?xml version="1.0"?><X3D><Scene><Shape><IndexedFaceSet solid="false" coordIndex="0 1 2 -1"><Coordinate point="0 0 0 2 0 0 0 2 0"/></IndexedFaceSet></Shape></Scene></X3D>\n' >one.x3d
tap_check "a format that the library alone reads says what may be missing" says one.x3d \
    'one.x3d: its colours, pictures and copies of things may be missing without a word'

mkdir dae && (cd dae && python3 -c 'import sys; sys.path.insert(0, sys.argv[1]); import one_square, one_square_xml
one_square_xml.write_collada(one_square.Thing("morph targets", True))' "$(dirname "$files")") &&
    sed 's|</visual_scene>|<node id="plain"><instance_geometry url="#g"/></node>&|' dae/a.dae >morph.dae
tap_check "meshes that the library does not read are told as the reason" refuses morph.dae \
    'it has meshes with morph targets, which the importer does not read: export it without'

printf 'PK\003\004and what a ZIP archive has' >packed.amf
tap_check "an archive is called one" refuses packed.amf 'it is compressed, as a ZIP archive: unpack it, and give what is in it'
printf 'MeshVersionFormatted 2\nDimension 3\nVertices\n0\nEnd\n' >medit.mesh
tap_check "what readers of other kinds have tried is unknown" refuses medit.mesh \
    'not in a format that the importer knows; glTF, OBJ, PLY, STL and others are: limner formats'
printf 'BLENDER-v304REND' >new.blend
blend_helps() { ! "$limner" compile new.blend -o none 2>told >/dev/null && cat told && grep -q '; export glTF from Blender$' told; }
tap_check "of Blender's own files it says what helps" blend_helps

mkdir said && python3 "$files" said said && cp said/bright.gltf said/named.gltf said/nul.gltf .
tap_check "light beyond 1 is told" says bright.gltf 'bright.gltf: 2 faces emit more than 1 of red, green or blue: it is drawn as 1'
own_name() {
    "$limner" compile named.gltf -o named --report >said.txt 2>&1 && cat said.txt && grep -q 'texture leaf (\*0)' said.txt
}
tap_check "pictures inside a file go by their own names" own_name
# Two pictures whose long names differ at their ends are two; a name of its own is the whole name.
long_names() {
    long=$(printf '%0600d' 0 | sed 's/.\{120\}/&\//g')
    mkdir -p "$long" && cp said/*.png "$long/" 2>/dev/null
    printf 'v 0 0 0\nv 2 0 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 0 1\nmtllib long.mtl\nusemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 3/3 2/2 1/1\n' >long.obj
    printf 'newmtl a\nmap_Kd %sa.png\nnewmtl b\nmap_Kd %sb.png\n' "$long" "$long" >long.mtl
    "$limner" compile long.obj --no-textures -o long --report >told 2>&1
    cat told
    grep -q 'a.png' told && grep -q 'b.png' told
}
tap_check "names of 600 characters are told apart by their ends" long_names
tap_check "a text with a character that no text has" refuses nul.gltf 'a text in it has the character \u0000'
tap_done
