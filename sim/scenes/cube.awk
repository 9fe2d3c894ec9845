# SPDX-License-Identifier: MIT
#
# The rooms with a cube of 1 m that hangs in the first of them and turns about a slanted axis, 3 degrees a frame of 1/15 s:
# what delta output is measured with before a still camera. Reads rooms.obj, writes a COLLADA file, which holds
# animations as text; with -v cameras=1 the camera instead, a line a frame.

function source(id, count, stride, kind, names, values,    i, n, list) {
    n = split(names, list, " ")
    for (i = 1; i <= n; i++)
        list[i] = "<param name=\"" list[i] "\" type=\"" kind "\"/>"
    print "<source id=\"" id "\"><" (kind == "name" ? "Name" : "float") "_array id=\"" id "-array\" count=\"" \
        count * stride "\">" values "</" (kind == "name" ? "Name" : "float") "_array><technique_common>" \
        "<accessor source=\"#" id "-array\" count=\"" count "\" stride=\"" stride "\">"
    for (i = 1; i <= n; i++)
        print list[i]
    print "</accessor></technique_common></source>"
}

function material(id, colour) {
    effects = effects "<effect id=\"" id "-effect\"><profile_COMMON><technique sid=\"t\"><lambert><diffuse><color>" \
        colour " 1</color></diffuse></lambert></technique></profile_COMMON></effect>\n"
    materials = materials "<material id=\"" id "-material\"><instance_effect url=\"#" id "-effect\"/></material>\n"
}

function instance(id) {
    print "<instance_geometry url=\"#" id "\"><bind_material><technique_common><instance_material symbol=\"" id \
        "\" target=\"#" id "-material\"/></technique_common></bind_material></instance_geometry>"
}

function geometry(id, corner_count, corners, face_count, sizes, faces) {
    print "<geometry id=\"" id "\"><mesh>"
    source(id "-corners", corner_count, 3, "float", "X Y Z", corners)
    print "<vertices id=\"" id "-vertices\"><input semantic=\"POSITION\" source=\"#" id "-corners\"/></vertices>"
    print "<polylist material=\"" id "\" count=\"" face_count "\"><input semantic=\"VERTEX\" source=\"#" id "-vertices\" offset=\"0\"/>"
    print "<vcount>" sizes "</vcount><p>" faces "</p></polylist></mesh></geometry>"
}

# Corner c has its bits 0, 1, 2 as x, y, z; faces are counter-clockwise from outside.
function cube(    c, corners) {
    for (c = 0; c < 8; c++)
        corners = corners " " (c % 2 - 0.5) " " (int(c / 2) % 2 - 0.5) " " (int(c / 4) - 0.5)
    geometry("cube", 8, corners, 6, "4 4 4 4 4 4", "0 4 6 2 1 3 7 5 0 1 5 4 2 6 7 3 0 2 3 1 4 5 7 6")
}

function turning(    k, times, angles, ways) {
    for (k = 0; k <= 12; k++) {
        times = times " " (k * 10 / 15)
        angles = angles " " (k * 30)
        ways = ways " LINEAR"
    }
    print "<library_animations><animation id=\"turning\">"
    source("times", 13, 1, "float", "TIME", times)
    source("angles", 13, 1, "float", "ANGLE", angles)
    source("ways", 13, 1, "name", "INTERPOLATION", ways)
    print "<sampler id=\"turn\"><input semantic=\"INPUT\" source=\"#times\"/><input semantic=\"OUTPUT\" source=\"#angles\"/>"
    print "<input semantic=\"INTERPOLATION\" source=\"#ways\"/></sampler>"
    print "<channel source=\"#turn\" target=\"turner/turn.ANGLE\"/></animation></library_animations>"
}

$1 == "v" { corners = corners " " $2 " " $3 " " $4; corner_count++ }

$1 == "f" {
    face_count++
    sizes = sizes " " (NF - 1)
    for (i = 2; i <= NF; i++)
        faces = faces " " ($i - 1)
}

END {
    if (cameras) {
        for (k = 0; k < 120; k++)
            print "0.5 1.6 0 3 1.4 0"
        exit
    }
    material("rooms", "0.6 0.6 0.6")
    material("cube", "0.9 0.4 0.1")
    print "<?xml version=\"1.0\" encoding=\"utf-8\"?>"
    print "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
    print "<asset><unit meter=\"1\" name=\"meter\"/><up_axis>Y_UP</up_axis></asset>"
    print "<library_effects>" effects "</library_effects><library_materials>" materials "</library_materials>"
    print "<library_geometries>"
    geometry("rooms", corner_count, corners, face_count, sizes, faces)
    cube()
    print "</library_geometries>"
    turning()
    print "<library_visual_scenes><visual_scene id=\"scene\"><node id=\"house\">"
    instance("rooms")
    print "</node><node id=\"turner\" name=\"cube\"><translate>2.9 1.4 0</translate>"
    print "<rotate sid=\"turn\">0.6 0.8 0 0</rotate>"
    instance("cube")
    print "</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#scene\"/></scene></COLLADA>"
}
