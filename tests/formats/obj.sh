# SPDX-License-Identifier: MIT
#
# OBJ and MTL as people and programs write them are drawn, or a line says what is not; files that a model names are found
# where people have them. Files, rays and expected colours are those of tests/formats/obj.py.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
cases=$(pwd)/tests/formats/obj.py

holds() { # CASE SENTENCE
    mkdir -p "$work/$1/model" && cd "$work/$1/model" || exit 1
    tap_check "$2" env PYTHONDONTWRITEBYTECODE=1 python3 "$cases" "$limner" "$1"
}

holds colours "Kd of three numbers, of one, beyond 0..1, and of no RGB"
holds shine_changes_nothing "statements of shine, of bumps and of physically based materials change no flat colour"
holds unknown_statements "statements that are not known, or stand before newmtl, or come twice, are told in a line a kind"
holds transparency "Tr: MeshLab's is an opacity where nothing would be seen else; d comes before it"
holds damage "what is no number, or no corner, is refused by its line"
holds map_options "map_Kd: options that change nothing, and those that are left out, are no part of the name"
holds scale_and_offset "map_Kd: -s and -o"
holds no_places "faces without texture coordinates have the mean colour of their picture"
holds black_pictures "a picture times black is black, with a note; times no colour it is as it is"
holds picture_names "names of pictures: quotes, blanks, %20, comments, a - in front"
holds long_names "names of pictures that agree in their first 150 letters are two"
holds elsewhere "pictures of other folders and systems are found beside the model, with a note; or refused"
holds capitals "names that differ in capitals, if there is one such file"
holds libraries "mtllib: several on a line, blanks, quotes, other places, the model's own name"
holds missing_libraries "an MTL file that is not there is told of, with the faces that are grey for it"
holds materials "usemtl: names as they are, unknown ones, none"
holds layouts "ends of lines, blanks, tabs, comments, lines that go on, UTF-16"
holds corners "corners with and without numbers behind /, counted from the end, on a last line without end"
holds weights "a fourth number of v divides nothing"
holds vertex_colours "colours of vertices, up to 1 or to 255, and vertices without"
holds what_is_not_drawn "curves, lines and unknown statements are told in a line a kind"
tap_done
