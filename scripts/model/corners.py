"""Corners where the paint changes: edges of the low tank's faces are cut in two where that lets them carry more of it.

A low face has a colour at each corner and what lies between. Greedily the cut is made that takes away the most of
what all faces are off the high tank's texture by, as in M. Garland and P. Heckbert, Fast Polygonal Approximation of Terrains
and Height Fields (1995). All faces at an edge are cut with it, at the same place: nothing gapes.
"""
import itertools
import math

import numpy as np
from mathutils import Vector

from mesh import Face, key
from texture import tree

SAMPLE = 0.12  # metres between the places that are looked at
PLACES = (0.36, 0.5, 0.64)  # along an edge where it may be cut
SHORTEST = 0.5  # an edge to be cut, metres


def inside(points):
    """Places spread evenly over a triangle, in parts of its corners."""
    longest = max((points[i] - points[i - 1]).length for i in range(3))
    n = min(max(int(longest / SAMPLE), 3), 40)
    return np.array([(i + 1 / 3, j + 1 / 3, n - i - j - 2 / 3) for i in range(n) for j in range(n - i)]) / n


class Paint:
    """What the texture shows on the high tank, seen through pixels of a hand's width."""

    BLUR = 8  # texels that have become one
    REACH = 0.3  # metres before and behind a low face, where the high one's is

    def __init__(self, placed, image):
        size = len(image) // self.BLUR
        self.image = image.reshape(size, self.BLUR, size, self.BLUR, 3).mean((1, 3))
        self.tree = tree(placed)
        self.triangles = []
        for m, offset in placed:
            for f in m.faces:
                for tri in f.tris:
                    p = np.array([tuple(f.p[i] + Vector(offset)) for i in tri])
                    self.triangles.append((p, np.array([f.uv[i] for i in tri]) / self.BLUR))

    def colour(self, p, normal):
        """What someone sees who looks at a place of a face from straight before it."""
        hit = self.tree.ray_cast(p + normal * self.REACH, -normal, 2 * self.REACH)
        where, _, index, _ = hit if hit[0] is not None else self.tree.find_nearest(p)
        corners, uv = self.triangles[index]
        b, c = np.linalg.lstsq((corners[1:] - corners[0]).T, np.array(where) - corners[0], rcond=None)[0]
        x, y = (uv[0] + b * (uv[1] - uv[0]) + c * (uv[2] - uv[0])).astype(int)
        return self.image[min(max(y, 0), len(self.image) - 1), min(max(x, 0), len(self.image) - 1)]


class Triangle:
    def __init__(self, face, corners, offset, seen, paint):
        self.face, self.corners, self.offset, self.seen, self.paint = face, corners, Vector(offset), seen, paint
        parts = inside(corners)
        places = parts @ np.array([tuple(q + self.offset) for q in corners])
        colours = np.array([paint.colour(Vector(p), face.n) for p in places])
        best = np.linalg.lstsq(parts, colours, rcond=None)[0]
        area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).length / 2
        self.error = seen * area * ((parts @ best - colours) ** 2).sum(1).mean()

    def edges(self):
        for i in range(3):
            yield frozenset((key(self.corners[i - 1]), key(self.corners[i])))

    def cut(self, edge, where):
        """The two triangles that it becomes."""
        i = next(i for i, e in enumerate(self.edges()) if e == edge)
        a, b, c = self.corners[i - 1], self.corners[i], self.corners[(i + 1) % 3]
        halves = ((a, where, c), (where, b, c))
        return [Triangle(self.face, corners, self.offset, self.seen, self.paint) for corners in halves]


def ways_to_look():
    """From where a tank is looked at: from all around, by someone who stands or flies low."""
    for degrees in (3, 12, 28):
        y, r = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
        for k in range(16):
            yield Vector((r * math.cos(math.pi * k / 8), y, r * math.sin(math.pi * k / 8)))


def seen_share(scene, corners, normal, offset):
    """How much of a triangle's area is seen in the mean over all ways to look."""
    seen, ways = 0.0, list(ways_to_look())
    for part in ((0.6, 0.2, 0.2), (0.2, 0.6, 0.2), (0.2, 0.2, 0.6)):
        p = sum((q * k for q, k in zip(corners, part)), Vector((0, 0, 0))) + normal * 0.01 + Vector(offset)
        for d in ways:
            if d.dot(normal) > 0 and scene.ray_cast(p, d, 8.0)[0] is None:
                seen += d.dot(normal)
    return seen / (3 * len(ways))


def best_cut(edge, at_edge):
    """(what it takes away, for each triangle that it costs; place) of the best place to cut an edge."""
    ends = at_edge[0].corners
    a, b = sorted((q for q in ends if key(q) in edge), key=key)
    if (b - a).length < SHORTEST:
        return 0.0, None
    before = sum(t.error for t in at_edge)
    best = (0.0, None)
    for place in PLACES:
        where = a.lerp(b, place)
        after = sum(h.error for t in at_edge for h in t.cut(edge, where))
        best = max(best, ((before - after) / len(at_edge), where), key=lambda cut: cut[0])
    return best


def add_corners(placed, spare, paint):
    """Cuts edges of the meshes, given with where they stand in the tank, into at most `spare` more triangles."""
    scene = tree(placed)
    of_mesh = []
    for m, offset in placed:
        triangles = []
        for f in m.faces:
            for tri in f.tris:
                corners = [f.p[i] for i in tri]
                triangles.append(Triangle(f, corners, offset, seen_share(scene, corners, f.n, offset), paint))
        of_mesh.append(triangles)
    edges = {}
    for k, triangles in enumerate(of_mesh):
        for t in triangles:
            for e in t.edges():
                edges.setdefault((k, e), []).append(t)
    cuts = {}
    while True:
        for at in edges:
            if at not in cuts:
                cuts[at] = best_cut(at[1], edges[at])
        at = max((at for at in edges if len(edges[at]) <= spare), key=lambda at: cuts[at][0], default=None)
        if at is None or cuts[at][0] <= 0.0:
            break
        k, edge = at
        old, where = edges[at], cuts[at][1]
        spare -= len(old)
        new = list(itertools.chain.from_iterable(t.cut(edge, where) for t in old))
        for t in old:
            for e in t.edges():
                edges[k, e] = [u for u in edges[k, e] if u is not t]
                cuts.pop((k, e), None)
        for t in new:
            for e in t.edges():
                edges.setdefault((k, e), []).append(t)
                cuts.pop((k, e), None)
        edges = {at: there for at, there in edges.items() if there}
        of_mesh[k] = [t for t in of_mesh[k] if not any(t is u for u in old)] + new
    for (m, _), triangles in zip(placed, of_mesh):
        m.faces = [
            Face(list(t.corners), t.face.part, t.face.mat, t.face.dens, t.face.smooth, group=t.face.group)
            for t in triangles
        ]
