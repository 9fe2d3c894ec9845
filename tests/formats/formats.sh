# SPDX-License-Identifier: MIT
#
# What PLY, OFF, STL and 3MF files say of colours, pictures and places is drawn; and models come in metres where their
# files have a unit. Files, rays and expected colours are those of tests/formats/formats.py.
. tests/tap.sh

limner=$(cd "$BUILD" && pwd)/limner
cases=$(pwd)/tests/formats/formats.py
cd "$work" || exit 1

holds() { # CASE SENTENCE
    tap_check "$2" python3 "$cases" "$limner" "$1"
}

holds ply_face_colours "PLY: colours of faces, of every type and name"
holds ply_alpha "PLY: alpha of faces; where all of it is 0 it is not meant"
holds ply_faces_come_first "PLY: faces may come before their vertices"
holds ply_strips "PLY: strips, which -1 begins anew"
holds ply_vertex_places "PLY: places in a picture by vertex, under each of their names"
holds ply_corner_places "PLY: places in a picture by corner"
holds ply_pictures_by_number "PLY: several pictures, by the faces' numbers"
holds ply_corner_colours "PLY: colours that change over a face become their mean, with a note"
holds ply_points_up_to_255 "PLY: colours of float32 up to 255"
holds ply_damage "PLY: damage is told by its line or its face"
holds off_face_colours "OFF: colours of faces, as whole numbers, as parts, and of a map"
holds off_vertex_colours "OFF: colours of vertices, behind normals and before places; divisors"
holds off_many_corners "OFF: a face of 24 corners"
holds off_without_a_blank "OFF: counts that follow the first word without a blank"
holds off_damage "OFF: damage is told by its line"
holds stl_viscam "STL: colours as VisCAM and SolidView write them; bytes behind the end"
holds stl_magics "STL: colours as Magics writes them, of facets and of the part"
holds stl_text "STL: words in capitals, several solids, zeros behind the end"
holds mf_colours "3MF: base materials and groups of colours, of objects, triangles and corners"
holds mf_pictures "3MF: pictures in the file, mirrored ones as well"
holds mf_assemblies "3MF: objects of objects at their places, mirrored and squeezed"
holds mf_kinds "3MF: supports are left out; what is not read is told"
holds mf_units "3MF: metres, by the file's unit"
holds mf_is_z_up "3MF: z is up"
holds mf_damage "3MF: damage is told in a line"
holds fbx_units "FBX: metres, by UnitScaleFactor"
holds amf_units "AMF: metres, by its unit"
holds collada_units "Collada: metres, by its unit"
holds backs_are_told "a model that turns its back to every camera is told of"
holds far_places_are_told "texture coordinates that are too large are told of as such"
tap_done
