# SPDX-License-Identifier: MIT
#
# FBX as text: Thing of one_square.py -> a.fbx.
SECOND = 46186158000  # of FBX's clock


def numbers(values):
    values = list(values)
    return "*%d { a: %s }" % (len(values), ",".join("%r" % v for v in values))


def properties(*rows):
    """(name, type, values)"""
    out = "".join('  P: "%s", "%s", "", "",%s\n' % (name, kind, ",".join("%r" % v for v in values)) for name, kind, *values in rows)
    return " Properties70: {\n%s }" % out


class File:
    def __init__(self):
        self.objects, self.links, self.next = [], [], 100

    def add(self, kind, name, sort, inside=""):
        self.next += 1
        self.objects.append('%s: %d, "%s", "%s" {\n%s\n}' % (kind, self.next, name, sort, inside))
        return self.next

    def link(self, what, to, by=None):
        self.links.append(' C: "OP",%d,%d, "%s"' % (what, to, by) if by else ' C: "OO",%d,%d' % (what, to))


def layers(t):
    out, used = "", ["Material"]
    out += ' LayerElementMaterial: 0 { Version: 101\n Name: ""\n MappingInformationType: "AllSame"\n' \
           ' ReferenceInformationType: "IndexToDirect"\n Materials: *1 { a: 0 } }\n'
    if t.ends:
        used.append("Color")
        out += ' LayerElementColor: 0 { Version: 101\n Name: ""\n MappingInformationType: "ByPolygonVertex"\n' \
               ' ReferenceInformationType: "Direct"\n Colors: %s }\n' % numbers(v for c in t.ends for v in (*(x / 255 for x in c), 1.0))
    if t.uvs:
        used.append("UV")
        out += ' LayerElementUV: 0 { Version: 101\n Name: ""\n MappingInformationType: "ByPolygonVertex"\n' \
               ' ReferenceInformationType: "Direct"\n UV: %s }\n' % numbers(c for uv in t.uvs for c in uv)
    if t.has("normals"):
        used.append("Normal")
        out += ' LayerElementNormal: 0 { Version: 101\n Name: ""\n MappingInformationType: "ByPolygonVertex"\n' \
               ' ReferenceInformationType: "Direct"\n Normals: %s }\n' % numbers([1.0, 0.0, 0.0] * len(t.face))
    return out + " Layer: 0 { Version: 100\n%s }\n" % "".join(
        ' LayerElement: { Type: "LayerElement%s"\n TypedIndex: 0 }\n' % name for name in used)


def geometry(t, file):
    scale = 1.0 if t.feature == "units" else 100.0
    points = t.scaled(scale)
    corners = t.face[:-1] + [-t.face[-1] - 1]
    return file.add("Geometry", "Geometry::a", "Mesh", " Vertices: %s\n PolygonVertexIndex: %s\n GeometryVersion: 124\n%s" % (
        numbers(c for p in points for c in p), numbers(corners), layers(t)))


def material(t, file):
    def of(colour):
        return [c / 255 for c in colour]
    rows = [("DiffuseColor", "Color", *of(t.colour or ((255,) * 3 if t.ends or t.has_picture or t.feature == "opacity" else (200,) * 3)))]
    if t.feature in ("light of faces", "pictures of light"):
        rows = [("DiffuseColor", "Color", 0.0, 0.0, 0.0)]
    if t.has("light of faces"):
        rows += [("EmissiveColor", "Color", *of((255, 128, 0))), ("EmissiveFactor", "Number", 1.0)]
    if t.has("pictures of light"):
        rows += [("EmissiveColor", "Color", 1.0, 1.0, 1.0), ("EmissiveFactor", "Number", 1.0)]
    if t.has("opacity"):
        rows.append(("Opacity", "Number", 0.5))
    if t.has("shine"):
        rows += [("SpecularColor", "Color", 1.0, 1.0, 1.0), ("Shininess", "Number", 90.0)]
    number = file.add("Material", "Material::m", "", ' Version: 102\n ShadingModel: "phong"\n' + properties(*rows))
    if t.has_picture or t.has("bumps"):
        wraps = 1 if t.has("clamped pictures") else 0
        rows = [("WrapModeU", "enum", wraps), ("WrapModeV", "enum", wraps)]
        if t.has("parts of pictures"):
            rows.append(("Translation", "Vector", 0.5, 0.0, 0.0))
        picture = file.add("Texture", "Texture::t", "", ' Type: "TextureVideoClip"\n Version: 202\n FileName: "four.png"\n'
                           ' RelativeFilename: "four.png"\n' + (" ModelUVTranslation: 0.5,0\n" if t.has("parts of pictures") else "") +
                           properties(*rows))
        file.link(picture, number, {"pictures of light": "EmissiveColor", "bumps": "Bump"}.get(t.feature, "DiffuseColor"))
    return number


def model(t, file, name, at=(0.0, 0.0, 0.0)):
    culling = "CullingOff" if t.has("faces with two sides") else "CullingOnCW"
    return file.add("Model", "Model::" + name, "Mesh", " Version: 232\n%s\n Shading: T\n Culling: \"%s\"" % (
        properties(("Lcl Translation", "Lcl Translation", *(c * 100 for c in at))), culling))


def animate(file, node):
    stack, layer = file.add("AnimationStack", "AnimStack::s", ""), file.add("AnimationLayer", "AnimLayer::l", "")
    curves = file.add("AnimationCurveNode", "AnimCurveNode::T", "", properties(("d|X", "Number", 100.0), ("d|Y", "Number", 0.0),
                                                                              ("d|Z", "Number", 0.0)))
    curve = file.add("AnimationCurve", "AnimCurve::", "", " Default: 0\n KeyVer: 4009\n KeyTime: *2 { a: 0,%d }\n"
                     " KeyValueFloat: *2 { a: 100,200 }\n KeyAttrFlags: *1 { a: 24836 }\n KeyAttrDataFloat: *4 { a: 0,0,0,0 }\n"
                     " KeyAttrRefCount: *1 { a: 2 }" % SECOND)
    file.link(layer, stack)
    file.link(curves, layer)
    file.link(curves, node, "Lcl Translation")
    file.link(curve, curves, "d|X")


MATRIX = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]


def skin(file, mesh):
    deformer = file.add("Deformer", "Deformer::", "Skin", " Version: 101\n Link_DeformAcuracy: 50")
    cluster = file.add("Deformer", "SubDeformer::", "Cluster", ' Version: 100\n UserData: "", ""\n Indexes: *4 { a: 0,1,2,3 }\n'
                       " Weights: *4 { a: 1,1,1,1 }\n Transform: %s\n TransformLink: %s" % (numbers(MATRIX), numbers(MATRIX)))
    joint = file.add("Model", "Model::joint", "LimbNode", " Version: 232\n" + properties(
        ("Lcl Translation", "Lcl Translation", 100.0, 0.0, 0.0)))
    file.link(joint, 0)
    file.link(deformer, mesh)
    file.link(cluster, deformer)
    file.link(joint, cluster)


def morph(file, mesh):
    shape = file.add("Geometry", "Geometry::shape", "Shape", " Version: 100\n Indexes: *4 { a: 0,1,2,3 }\n Vertices: %s\n Normals: %s" % (
        numbers([100.0, 0.0, 0.0] * 4), numbers([0.0] * 12)))
    deformer = file.add("Deformer", "Deformer::", "BlendShape", " Version: 100")
    channel = file.add("Deformer", "SubDeformer::", "BlendShapeChannel", " Version: 100\n DeformPercent: 100\n FullWeights: *1 { a: 100 }\n" +
                       properties(("DeformPercent", "Number", 100.0)))
    file.link(deformer, mesh)
    file.link(channel, deformer)
    file.link(shape, channel)


def write_fbx(t):
    file = File()
    mesh, look = geometry(t, file), material(t, file)
    places = (-1.0, 1.0) if t.has("nodes and instances") else (0.0,)
    for i, x in enumerate(places):
        node = model(t, file, "n%d" % i, (x, 0.0, 0.0))
        for what, to in ((node, 0), (mesh, node), (look, node)):
            file.link(what, to)
    if t.has("animated nodes"):
        animate(file, node)
    if t.has("skins"):
        skin(file, mesh)
    if t.has("morph targets"):
        morph(file, mesh)
    if t.has("lines and points"):
        line = file.add("Geometry", "Geometry::l", "Line", " Points: %s\n PointsIndex: *2 { a: 0,-3 }" % numbers(
            c for p in t.scaled(100.0) for c in p))
        file.link(line, node)
    for feature, sort in (("lights", "Light"), ("cameras", "Camera")):
        if t.has(feature):
            attribute = file.add("NodeAttribute", "NodeAttribute::x", sort, ' TypeFlags: "%s"\n GeometryVersion: 124' % sort)
            other = file.add("Model", "Model::x", sort, " Version: 232")
            file.link(other, 0)
            file.link(attribute, other)
    settings = [("UpAxis", "int", 2 if t.has("up axis") else 1), ("UpAxisSign", "int", 1), ("FrontAxis", "int", 1 if t.has("up axis") else 2),
                ("FrontAxisSign", "int", -1 if t.has("up axis") else 1), ("CoordAxis", "int", 0), ("CoordAxisSign", "int", 1)]
    settings.append(("UnitScaleFactor", "double", 100.0 if t.has("units") else 1.0))
    open("a.fbx", "w").write("; FBX 7.3.0 project file\nFBXHeaderExtension: { FBXHeaderVersion: 1003\n FBXVersion: 7300 }\n"
                             "GlobalSettings: { Version: 1000\n%s }\nObjects: {\n%s\n}\nConnections: {\n%s\n}\n" % (
                                 properties(*settings), "\n".join(file.objects), "\n".join(file.links)))
    return "a.fbx"
