# SPDX-License-Identifier: MIT
#
# Collada: Thing of one_square.py -> a.dae.


def parts(colour):
    return " ".join("%.6f" % (c / 255) for c in colour)


def source(name, rows, params):
    values = " ".join("%r" % float(c) for row in rows for c in row)
    return '<source id="%s"><float_array id="%s_a" count="%d">%s</float_array><technique_common><accessor source="#%s_a" count="%d" ' \
           'stride="%d">%s</accessor></technique_common></source>' % (
               name, name, len(rows) * len(params), values, name, len(rows), len(params),
               "".join('<param name="%s" type="float"/>' % p for p in params))


def geometry(t):
    scale = 100.0 if t.feature == "units" else 1.0
    sources, inputs, count = source("p", t.scaled(scale), "XYZ"), '<input semantic="VERTEX" source="#v" offset="0"/>', 1
    for name, semantic, rows, params in (("c", "COLOR", [tuple(c / 255 for c in e) + (1.0,) for e in t.ends or ()], "RGBA"),
                                         ("uv", "TEXCOORD", t.uvs or [], "ST"),
                                         ("nn", "NORMAL", [(1.0, 0.0, 0.0)] * 4 if t.has("normals") else [], "XYZ")):
        if rows:
            sources += source(name, rows, params)
            inputs += '<input semantic="%s" source="#%s" offset="0"%s/>' % (semantic, name, ' set="0"' if name == "uv" else "")
    faces = '<polylist count="%d" material="m">%s<vcount>%d</vcount><p>%s</p></polylist>' % (
        count, inputs, len(t.face), " ".join(map(str, t.face)))
    if t.has("lines and points"):
        faces += '<lines count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2</p></lines>'
    out = '<geometry id="g"><mesh>%s<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>%s</mesh></geometry>' % (sources, faces)
    if t.has("morph targets"):
        moved = source("q", [(x + 1, y, z) for x, y, z in t.points], "XYZ")
        out += '<geometry id="g2"><mesh>%s<vertices id="w"><input semantic="POSITION" source="#q"/></vertices>%s</mesh></geometry>' % (
            moved, faces.replace("#v", "#w"))
    if t.has("curves and surfaces"):
        out += '<geometry id="g3"><spline>%s<control_vertices><input semantic="POSITION" source="#k"/></control_vertices></spline></geometry>' % (
            source("k", t.points, "XYZ"))
    return out


def effect(t):
    def colour(name, value, alpha=1.0):
        return "<%s><color>%s %.3f</color></%s>" % (name, parts(value), alpha, name)
    params, extra, texture = "", "", ""
    if t.has_picture or t.has("bumps"):
        wrap = {"clamped pictures": "CLAMP", "mirrored pictures": "MIRROR"}.get(t.feature, "WRAP") if t.said else "WRAP"
        params = '<newparam sid="su"><surface type="2D"><init_from>i</init_from></surface></newparam><newparam sid="sa"><sampler2D>' \
                 '<source>su</source><wrap_s>%s</wrap_s><wrap_t>%s</wrap_t></sampler2D></newparam>' % (wrap, wrap)
        moved = '<extra><technique profile="MAYA"><offsetU>0.5</offsetU><wrapU>1</wrapU></technique></extra>'
        clamped = {"clamped pictures": "<wrapU>0</wrapU><wrapV>0</wrapV>",
                   "mirrored pictures": "<wrapU>1</wrapU><wrapV>1</wrapV><mirrorU>1</mirrorU><mirrorV>1</mirrorV>"}
        inside = moved if t.has("parts of pictures") else ""
        if t.said and t.feature in clamped:
            inside = '<extra><technique profile="MAYA">%s</technique></extra>' % clamped[t.feature]
        texture = '<texture texture="sa" texcoord="UV0">%s</texture>' % inside
    emission = diffuse = ""
    if t.has("light of faces"):
        emission = colour("emission", (255, 128, 0))
    if t.feature in ("light of faces", "pictures of light"):
        diffuse = colour("diffuse", (0, 0, 0))
    elif t.has_picture:
        diffuse = "<diffuse>%s</diffuse>" % texture
    else:
        diffuse = colour("diffuse", t.colour or ((255,) * 3 if t.ends or t.feature == "opacity" else (200,) * 3))
    if t.has("pictures of light"):
        emission = "<emission>%s</emission>" % texture
    specular = "<specular><color>1 1 1 1</color></specular><shininess><float>90</float></shininess>" if t.has("shine") else ""
    clear = '<transparent opaque="A_ONE"><color>1 1 1 1</color></transparent><transparency><float>0.5</float></transparency>'
    if t.has("bumps"):
        extra = '<extra><technique profile="FCOLLADA"><bump>%s</bump></technique></extra>' % texture
    if t.has("faces with two sides"):
        extra = '<extra><technique profile="GOOGLEEARTH"><double_sided>1</double_sided></technique></extra>'
    return '<library_effects><effect id="e"><profile_COMMON>%s<technique sid="t"><phong>%s%s%s%s</phong>%s</technique></profile_COMMON>' \
           '</effect></library_effects><library_materials><material id="mm"><instance_effect url="#e"/></material></library_materials>' % (
               params, emission, diffuse, specular, clear if t.has("opacity") else "", extra)


BIND = '<bind_material><technique_common><instance_material symbol="m" target="#mm"><bind_vertex_input semantic="UV0" ' \
       'input_semantic="TEXCOORD" input_set="0"/></instance_material></technique_common></bind_material>'


def node(name, inside, at=(0.0, 0.0, 0.0), more=""):
    return '<node id="%s" name="%s" sid="%s" %s><translate sid="at">%g %g %g</translate>%s</node>' % (name, name, name, more, *at, inside)


def name_source(name, kind, words):
    return '<source id="%s"><%s id="%s_a" count="%d">%s</%s><technique_common><accessor source="#%s_a" count="%d" stride="1"><param ' \
           'name="X" type="name"/></accessor></technique_common></source>' % (name, kind, name, len(words), " ".join(words), kind, name, len(words))


def controllers(t):
    if t.has("morph targets"):
        inside = '<morph source="#g" method="NORMALIZED">%s%s<targets><input semantic="MORPH_TARGET" source="#mt"/><input ' \
                 'semantic="MORPH_WEIGHT" source="#mw"/></targets></morph>' % (
                     name_source("mt", "IDREF_array", ["g2"]), source("mw", [(1.0,)], "X"))
    elif t.has("skins"):
        unit = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"
        bind = '<source id="sb"><float_array id="sb_a" count="16">%s</float_array><technique_common><accessor source="#sb_a" count="1" ' \
               'stride="16"><param name="TRANSFORM" type="float4x4"/></accessor></technique_common></source>' % unit
        inside = '<skin source="#g"><bind_shape_matrix>%s</bind_shape_matrix>%s%s%s<joints><input semantic="JOINT" source="#sj"/><input ' \
                 'semantic="INV_BIND_MATRIX" source="#sb"/></joints><vertex_weights count="4"><input semantic="JOINT" source="#sj" ' \
                 'offset="0"/><input semantic="WEIGHT" source="#sw" offset="1"/><vcount>1 1 1 1</vcount><v>0 0 0 0 0 0 0 0</v>' \
                 '</vertex_weights></skin>' % (unit, name_source("sj", "Name_array", ["joint"]), bind, source("sw", [(1.0,)], "X"))
    else:
        return ""
    return '<library_controllers><controller id="k1">%s</controller></library_controllers>' % inside


def animation():
    return '<library_animations><animation>%s%s%s<sampler id="as"><input semantic="INPUT" source="#ai"/><input semantic="OUTPUT" ' \
           'source="#ao"/><input semantic="INTERPOLATION" source="#an"/></sampler><channel source="#as" target="n0/at.X"/></animation>' \
           '</library_animations>' % (source("ai", [(0.0,), (1.0,)], "X"), source("ao", [(1.0,), (2.0,)], "X"),
                                      name_source("an", "Name_array", ["LINEAR", "LINEAR"]))


def write_collada(t):
    shown = '<instance_geometry url="#g">%s</instance_geometry>' % BIND
    if t.has("morph targets") or t.has("skins"):
        shown = '<instance_controller url="#k1">%s%s</instance_controller>' % ("<skeleton>#joint</skeleton>" if t.has("skins") else "", BIND)
    places = (-1.0, 1.0) if t.has("nodes and instances") else (0.0,)
    nodes = "".join(node("n%d" % i, shown, (x, 0.0, 0.0)) for i, x in enumerate(places))
    if t.has("skins"):
        nodes += node("joint", "", (1.0, 0.0, 0.0), 'type="JOINT"')
    if t.has("curves and surfaces"):
        nodes += node("curve", '<instance_geometry url="#g3"/>')
    libraries = controllers(t) + (animation() if t.has("animated nodes") else "")
    if t.has_picture or t.has("bumps"):
        libraries += '<library_images><image id="i"><init_from>four.png</init_from></image></library_images>'
    if t.has("lights"):
        libraries += '<library_lights><light id="l"><technique_common><point><color>1 0 0</color></point></technique_common></light></library_lights>'
        nodes += node("lit", '<instance_light url="#l"/>')
    if t.has("cameras"):
        libraries += '<library_cameras><camera id="cam"><optics><technique_common><perspective><yfov>50</yfov><aspect_ratio>1</aspect_ratio>' \
                     '<znear>0.1</znear><zfar>9</zfar></perspective></technique_common></optics></camera></library_cameras>'
        nodes += node("seen", '<instance_camera url="#cam"/>')
    unit = '<unit name="u" meter="%r"/>' % 0.01 if t.has("units") else ""
    open("a.dae", "w").write(
        '<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>%s<up_axis>%s</up_axis>'
        '</asset>%s%s<library_geometries>%s</library_geometries><library_visual_scenes><visual_scene id="s">%s</visual_scene>'
        '</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>' % (
            unit, "Z_UP" if t.has("up axis") else "Y_UP", effect(t), libraries, geometry(t), nodes))
    return "a.dae"
