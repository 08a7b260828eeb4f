"""Polygons with a memory: what a face is made of, how it shades, and where its texture lives.

A Mesh is a list of faces in metres. begin() opens a part: smoothing never crosses parts. Charts
(pieces of the unwrapped texture) are made as the faces are, so that a stamped copy of a part may
either share the texture of the original or get its own.
"""
import itertools
import math

from mathutils import Matrix, Vector

_part = itertools.count(1)
_chart = itertools.count(1)

# Frames: local (x, y) is the profile's plane, local z the direction of extrusion.
FRONT = Matrix.Identity(4)  # profile (x, y) along Z
SIDE = Matrix(((0, 0, 1, 0), (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 0, 1)))  # profile (y, z) along X
TOP = Matrix(((0, 1, 0, 0), (0, 0, 1, 0), (1, 0, 0, 0), (0, 0, 0, 1)))  # profile (z, x) along Y
MIRROR = Matrix.Diagonal((-1, 1, 1, 1))


def at(x, y, z):
    return Matrix.Translation((x, y, z))


def turn(axis, degrees):
    return Matrix.Rotation(math.radians(degrees), 4, axis)


def normal_of(p):
    n = Vector((0, 0, 0))
    for i in range(1, len(p) - 1):
        n += (p[i] - p[0]).cross(p[i + 1] - p[0])
    return n * 0.5  # its length is the area


def triangulate(p):
    """Indices of the triangles of a simple, nearly flat polygon: the fattest ear first."""
    if len(p) == 3:
        return [(0, 1, 2)]
    n = normal_of(p).normalized()
    left, out = list(range(len(p))), []
    if len(p) == 4:
        if (p[0] - p[2]).length <= (p[1] - p[3]).length + 1e-4:  # a tie falls the same way in every copy
            cut = [(0, 1, 2), (0, 2, 3)]
        else:
            cut = [(0, 1, 3), (1, 2, 3)]
        if all(normal_of([p[i] for i in t]).dot(n) > 1e-9 for t in cut):
            return cut
    while len(left) > 3:
        best = None
        for k in range(len(left)):
            a, b, c = left[k - 1], left[k], left[(k + 1) % len(left)]
            area = (p[b] - p[a]).cross(p[c] - p[b]).dot(n)
            if area < 1e-9:
                continue
            inside = False
            for q in left:
                if q in (a, b, c):
                    continue
                s = [(p[v] - p[u]).cross(p[q] - p[u]).dot(n) for u, v in ((a, b), (b, c), (c, a))]
                if min(s) > -1e-9:
                    inside = True
                    break
            if inside:
                continue
            perimeter = (p[b] - p[a]).length + (p[c] - p[b]).length + (p[a] - p[c]).length
            score = area / (perimeter * perimeter)
            if best is None or score > best[0] + 1e-12:
                best = (score, k, (a, b, c))
        if best is None:
            raise ValueError('polygon cannot be cut: %s' % p)
        out.append(best[2])
        del left[best[1]]
    out.append(tuple(left))
    return out


class Face:
    __slots__ = ('p', 'part', 'mat', 'chart', 'uv', 'dens', 'smooth', 'copy', 'group', 'n', 'tris', 'area')

    def __init__(self, p, part, mat, dens, smooth, uv=None, chart=0, copy=False, group=''):
        self.p, self.part, self.mat, self.dens, self.smooth = p, part, mat, dens, smooth
        self.uv, self.chart, self.copy, self.group = uv, chart, copy, group
        n = normal_of(p)
        self.area = n.length
        self.n = n.normalized()
        self.tris = triangulate(p)


def key(v):
    return (round(v[0] * 1000), round(v[1] * 1000), round(v[2] * 1000))


def new_chart():
    return next(_chart)


class Mesh:
    def __init__(self, name):
        self.name, self.faces, self.group = name, [], ''
        self.begin()

    def begin(self, mat='paint', dens=1.0, smooth=50):
        self.id, self.mat, self.dens, self.smooth = next(_part), mat, dens, smooth
        return self

    def poly(self, points, uv=None, chart=0):
        points = [Vector(q) for q in points]
        keep = [i for i in range(len(points)) if key(points[i]) != key(points[i - 1])]
        p = [points[i] for i in keep]
        if len(p) < 3 or normal_of(p).length < 2e-7:
            return
        self.faces.append(
            Face(
                p,
                self.id,
                self.mat,
                self.dens,
                self.smooth,
                [tuple(uv[i]) for i in keep] if uv else None,
                chart,
                group=self.group,
            )
        )

    # ---- copies
    def since(self, mark):
        """The faces made since len(faces) was mark, unwrapped."""
        made = self.faces[mark:]
        unwrap(made)
        return made

    def stamp(self, faces, matrix, share=True):
        parts, charts = {}, {}
        flip = matrix.determinant() < 0
        for f in faces:
            if f.part not in parts:
                parts[f.part] = next(_part)
            chart, uv = f.chart, list(f.uv)
            if not share:
                if chart not in charts:
                    charts[chart] = next(_chart)
                chart = charts[chart]
                uv = [(-u, v) for u, v in uv] if flip else uv
            p = [matrix @ q for q in f.p]
            if flip:
                p.reverse()
                uv.reverse()
            group = f.group.replace('left_', 'right_') if flip else f.group
            made = Face(p, parts[f.part], f.mat, f.dens, f.smooth, uv, chart, share, group)
            last = len(p) - 1  # cut as its original is
            made.tris = [(last - c, last - b, last - a) for a, b, c in f.tris] if flip else f.tris
            self.faces.append(made)

    def both(self, build, share=True):
        """build() makes the left side (+X); the right side is its mirror image."""
        mark = len(self.faces)
        build()
        self.stamp(self.since(mark), MIRROR, share)

    def wheel_of(self, build, count, turned, chain):
        """build() makes one sector; the others are its copies, turned(k) from it, and shade as one with it.
        Sector k is the group left_CHAIN_k."""
        mark = len(self.faces)
        build()
        made = self.since(mark)
        for f in made:
            f.group = 'left_%s_00' % chain
        for k in range(1, count):
            first = len(self.faces)
            self.stamp(made, turned(k))
            for f, g in zip(self.faces[first:], made):
                f.part, f.group = g.part, 'left_%s_%02d' % (chain, k)

    def many(self, build, matrices, share=True):
        """build() makes the thing at the origin; the original itself is moved to matrices[0]."""
        mark = len(self.faces)
        build()
        made = self.since(mark)
        del self.faces[mark:]
        self.stamp(made, matrices[0], False)
        first = self.faces[mark:]
        back = matrices[0].inverted()
        for m in matrices[1:]:
            self.stamp(first, m @ back, share)


def unwrap(faces):
    """Gives every face without a chart one: neighbours facing about the same way share it."""
    todo = [f for f in faces if f.uv is None]
    edges = {}
    for f in todo:
        k = [key(q) for q in f.p]
        for i in range(len(k)):
            edges.setdefault((f.part, min(k[i - 1], k[i]), max(k[i - 1], k[i])), []).append(f)
    near = {id(f): [] for f in todo}
    for pair in edges.values():
        for f in pair:
            near[id(f)] += [g for g in pair if g is not f]
    for seed in sorted(todo, key=lambda f: -round(f.area, 5)):
        if seed.uv is not None:
            continue
        chart, n = next(_chart), seed.n
        i = max(range(len(seed.p)), key=lambda j: round((seed.p[j] - seed.p[j - 1]).length, 4))
        e = (seed.p[i] - seed.p[i - 1]).normalized()
        e = (e - n * e.dot(n)).normalized()
        w = n.cross(e)
        stack = [seed]
        while stack:
            f = stack.pop()
            if f.uv is not None:
                continue
            f.uv, f.chart = [(q.dot(e), q.dot(w)) for q in f.p], chart
            for g in near[id(f)]:
                if g.uv is None and g.n.dot(n) > 0.5 and g.n.dot(f.n) > 0.6 and g.mat == f.mat:
                    stack.append(g)
