# SPDX-License-Identifier: MIT
#
# Rooms with dense things in them, as OBJ and MTL: awk -v seed=N -v things=N -v how=HOW [-v dense=N] -v mtl=FILE -f furnished.awk.
# HOW: apart, at random places and scales; touching, at the walls and at each other; inside, one in another; sheets, of no
# thickness and seen from both sides; planes, where the partition's plane goes through them. Each has dense * dense / 2
# polygons or so.
function vertex(x, y, z) { printf "v %.9g %.9g %.9g\n", x, y, z; return ++vertices }
function quad(a, b, c, d) { print "f", a, b, c, d }
# A box; out: seen from outside.
function box(x0, y0, z0, x1, y1, z1, out,    i, v) {
    for (i = 0; i < 8; i++) v[i] = vertex(i % 2 ? x1 : x0, int(i / 2) % 2 ? y1 : y0, int(i / 4) ? z1 : z0)
    if (out) { face(v, 0, 2, 3, 1); face(v, 4, 5, 7, 6); face(v, 0, 1, 5, 4); face(v, 2, 6, 7, 3); face(v, 0, 4, 6, 2); face(v, 1, 3, 7, 5) }
    else { face(v, 1, 3, 2, 0); face(v, 6, 7, 5, 4); face(v, 4, 5, 1, 0); face(v, 3, 7, 6, 2); face(v, 2, 6, 4, 0); face(v, 5, 7, 3, 1) }
}
function face(v, a, b, c, d) { quad(v[a], v[b], v[c], v[d]) }
# A ball or a ring about (x, y, z) of radius r: rows of quads round and round.
function ring(x, y, z, r, thick, tilt,    i, k, n, m, u, w, px, py, pz, v) {
    n = dense; m = int(dense / 2)
    for (i = 0; i < n; i++)
        for (k = 0; k < m; k++) {
            u = 6.283185307 * i / n; w = 6.283185307 * k / m
            px = (r - thick + thick * cos(w)) * cos(u); pz = (r - thick + thick * cos(w)) * sin(u); py = thick * sin(w)
            v[i, k] = vertex(x + px, y + py * cos(tilt) - pz * sin(tilt), z + py * sin(tilt) + pz * cos(tilt))
        }
    for (i = 0; i < n; i++)
        for (k = 0; k < m; k++) quad(v[i, k], v[i, (k + 1) % m], v[(i + 1) % n, (k + 1) % m], v[(i + 1) % n, k])
}
function ball(x, y, z, r,    i, k, n, m, u, w, v, top, foot) {
    n = dense; m = int(dense / 2)
    top = vertex(x, y + r, z); foot = vertex(x, y - r, z)
    for (k = 1; k < m; k++)
        for (i = 0; i < n; i++) {
            u = 6.283185307 * i / n; w = 3.141592654 * k / m
            v[k, i] = vertex(x + r * sin(w) * cos(u), y + r * cos(w), z - r * sin(w) * sin(u))
        }
    for (i = 0; i < n; i++) {
        print "f", top, v[1, i], v[1, (i + 1) % n]
        print "f", foot, v[m - 1, (i + 1) % n], v[m - 1, i]
        for (k = 1; k < m - 1; k++) quad(v[k, i], v[k + 1, i], v[k + 1, (i + 1) % n], v[k, (i + 1) % n])
    }
}
# A wavy sheet, both sides of which are faces.
function sheet(x, y, z, r,    i, k, v) {
    for (i = 0; i <= dense / 2; i++)
        for (k = 0; k <= dense / 2; k++) v[i, k] = vertex(x + r * (4 * i / dense - 1), y + r / 4 * sin(i / 2) * cos(k / 3), z + r * (4 * k / dense - 1))
    for (i = 0; i < int(dense / 2); i++)
        for (k = 0; k < int(dense / 2); k++) {
            print "f", v[i, k], v[i, k + 1], v[i + 1, k]; print "f", v[i, k + 1], v[i + 1, k + 1], v[i + 1, k]
            print "f", v[i, k], v[i + 1, k], v[i, k + 1]; print "f", v[i, k + 1], v[i + 1, k], v[i + 1, k + 1]
        }
}
function thing(i, x, y, z, r) {
    print "usemtl t" i % 5
    if (how == "sheets") sheet(x, y, z, r)
    else if (i % 2) ring(x, y, z, r, r / 3, i)
    else ball(x, y, z, r)
}
BEGIN {
    srand(seed); if (!dense) dense = 24
    for (i = 0; i < 5; i++) printf "newmtl t%d\nKd %.2f %.2f %.2f\n", i, 0.2 + 0.15 * i, 0.9 - 0.15 * i, 0.3 + i % 3 / 4 > mtl
    printf "newmtl wall\nKd 0.8 0.8 0.7\nnewmtl post\nKd 0.5 0.3 0.2\n" > mtl
    close(mtl)
    name = mtl; sub(/.*\//, "", name)
    print "mtllib", name
    print "usemtl wall"; box(0, 0, 0, 12, 3, 8, 0)
    print "usemtl post"; box(6, 0, 0, 6.2, 3, 3, 1); box(6, 0, 5, 6.2, 3, 8, 1)
    for (i = 0; i < things; i++) {
        r = 0.15 + 0.35 * rand(); x = 0.6 + 10.8 * rand(); z = 0.6 + 6.8 * rand(); y = r + (2.9 - 2 * r) * rand() * rand()
        if (how == "planes") { x = 6 + (rand() - 0.5) * r; z = 3.5 + rand() }
        else if (x > 6 - r - 0.01 && x < 6.2 + r + 0.01) x = 3
        if (how == "touching" && i % 3 == 0) { x = r; y = r }
        if (how == "touching" && i % 3 == 1) { x = last_x + last_r + r; y = last_y; z = last_z }
        if (how == "inside" && i % 2) { x = last_x; y = last_y; z = last_z; r = last_r / 3; print "usemtl t4"; ball(x, y, z, r) }
        else thing(how == "inside" ? 1 : i, x, y, z, r)
        last_x = x; last_y = y; last_z = z; last_r = r
    }
}
