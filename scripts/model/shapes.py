"""Solids out of profiles: prism, stack, lathe, tube, box, slab. All face outward by themselves."""
import math

from mathutils import Matrix, Vector

from mesh import FRONT, TOP, new_chart


def area2(p):
    return sum(p[i - 1][0] * p[i][1] - p[i][0] * p[i - 1][1] for i in range(len(p)))


def inset(p, d):
    """The counter-clockwise polygon p with every edge moved inward by d."""
    out = []
    for i in range(len(p)):
        a, b, c = Vector(p[i - 1]), Vector(p[i]), Vector(p[(i + 1) % len(p)])
        u, v = (b - a).normalized(), (c - b).normalized()
        n1, n2 = Vector((-u.y, u.x)), Vector((-v.y, v.x))
        k = 1.0 + n1.dot(n2)
        out.append(tuple(b + (n1 + n2) * (d / max(k, 0.35))))
    return out


def cut_corners(p, d, only=None):
    """Every corner of p (or only the listed ones) chamfered by d along both edges."""
    out = []
    for i in range(len(p)):
        if only is not None and i not in only:
            out.append(p[i])
            continue
        a, b, c = Vector(p[i - 1]), Vector(p[i]), Vector(p[(i + 1) % len(p)])
        out.append(tuple(b + (a - b).normalized() * d))
        out.append(tuple(b + (c - b).normalized() * d))
    return out


def rect(x0, y0, x1, y1, cut=0.0):
    p = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    return cut_corners(p, cut) if cut else p


def ngon(n, r, x=0.0, y=0.0, start=0.0):
    return [
        (x + r * math.cos(start + 2 * math.pi * i / n), y + r * math.sin(start + 2 * math.pi * i / n)) for i in range(n)
    ]


def loft(m, rings, cap0=True, cap1=True, closed=True):
    """Rings are counter-clockwise as seen from the last one's side."""
    n = len(rings[0])
    for a, b in zip(rings, rings[1:]):
        for i in range(n if closed else n - 1):
            j = (i + 1) % n
            m.poly([a[i], a[j], b[j], b[i]])
    if cap0:
        m.poly(list(reversed(rings[0])))
    if cap1:
        m.poly(rings[-1])


def stack(m, layers, frame=FRONT, cap0=True, cap1=True):
    """Layers (profile, t) with equal point counts, joined along the frame's z."""
    if layers[0][1] > layers[-1][1]:
        layers = layers[::-1]
        cap0, cap1 = cap1, cap0
    if area2(layers[0][0]) < 0:
        layers = [(p[::-1], t) for p, t in layers]
    loft(m, [[frame @ Vector((x, y, t)) for x, y in p] for p, t in layers], cap0, cap1)


def prism(m, profile, a, b, frame=FRONT, bevel=(0, 0), cap0=True, cap1=True):
    p = profile if area2(profile) > 0 else profile[::-1]
    layers = [(inset(p, bevel[0]), a), (p, a + bevel[0])] if bevel[0] else [(p, a)]
    layers += [(p, b - bevel[1]), (inset(p, bevel[1]), b)] if bevel[1] else [(p, b)]
    stack(m, layers, frame, cap0, cap1)


def box(m, lo, hi, bevel=0.0, cut=0.0, frame=None, bottom=False, top=True):
    """Stands on its y-low face, which is left out unless asked for; the top edge is bevelled."""
    f = (frame @ TOP) if frame else TOP
    prism(m, rect(lo[2], lo[0], hi[2], hi[0], cut), lo[1], hi[1], f, (0, bevel), cap0=bottom, cap1=top)


def lathe(m, profile, n, frame=FRONT, start=0.0, made=None):
    """Profile (r, t) about the frame's z; the outside lies to the right of the way it is walked.
    Only the first `made` of the n segments, if given."""
    ring = [
        [
            frame @ Vector((r * math.cos(start + 2 * math.pi * i / n), r * math.sin(start + 2 * math.pi * i / n), t))
            for i in range(n)
        ]
        for r, t in profile
    ]
    chart, v0 = 0, 0.0
    for k in range(len(profile) - 1):
        (r0, t0), (r1, t1) = profile[k], profile[k + 1]
        length = math.hypot(r1 - r0, t1 - t0)
        flat = abs(t1 - t0) < abs(r1 - r0) * 0.75
        if flat:
            chart = 0
        elif not chart:
            chart, v0, rr = new_chart(), 0.0, max(r0, r1)
        for i in range(made or n):
            j = (i + 1) % n
            uv = None
            if chart:
                u0, u1 = (rr * 2 * math.pi * q / n for q in (i, i + 1))
                uv = [(u0, v0), (u1, v0), (u1, v0 + length), (u0, v0 + length)]
            m.poly([ring[k][i], ring[k][j], ring[k + 1][j], ring[k + 1][i]], uv, chart)
        v0 += length


def disc(m, r, t, n, frame=FRONT, start=0.0, up=True):
    p = [frame @ Vector((x, y, t)) for x, y in ngon(n, r, start=start)]
    m.poly(p if up else p[::-1])


def drum(m, r, a, b, n, frame=FRONT, bevel=0.0, start=0.0, cap0=True, cap1=True):
    """A capped cylinder along the frame's z."""
    prof = [(r - bevel, a), (r, a + bevel)] if bevel and cap0 else [(r, a)]
    prof += [(r, b - bevel), (r - bevel, b)] if bevel and cap1 else [(r, b)]
    lathe(m, prof, n, frame, start)
    if cap0:
        disc(m, prof[0][0], a, n, frame, start, up=False)
    if cap1:
        disc(m, prof[-1][0], b, n, frame, start)


def tube(m, path, r, n=5, caps=True, loop=False):
    path = [Vector(p) for p in path]
    count = len(path)
    rings, side = [], None
    for i, p in enumerate(path):
        prev = path[i - 1] if (i or loop) else p
        nxt = path[(i + 1) % count] if (i + 1 < count or loop) else p
        d1 = (p - prev).normalized() if p != prev else (nxt - p).normalized()
        d2 = (nxt - p).normalized() if p != nxt else d1
        d = (d1 + d2).normalized()
        if side is None:
            side = d.cross(Vector((0.13, 1, 0.21))).normalized()
        side = (side - d * side.dot(d)).normalized()
        up = d.cross(side)
        stretch = 1.0 / max(0.5, d.dot(d1))
        bend = d2 - d1
        bend = bend.normalized() if bend.length > 1e-6 else None
        ring = []
        for k in range(n):
            o = side * math.cos(2 * math.pi * k / n) + up * math.sin(2 * math.pi * k / n)
            if bend:
                o = o + bend * (o.dot(bend) * (stretch - 1))
            ring.append(p + o * r)
        rings.append(ring)
    chart, v = new_chart(), 0.0
    steps = list(zip(range(count), range(1, count))) + ([(count - 1, 0)] if loop else [])
    for a, b in steps:
        length = (path[b] - path[a]).length
        for i in range(n):
            j = (i + 1) % n
            u0, u1 = (2 * math.pi * r * q / n for q in (i, i + 1))
            m.poly(
                [rings[a][i], rings[a][j], rings[b][j], rings[b][i]],
                [(u0, v), (u1, v), (u1, v + length), (u0, v + length)],
                chart,
            )
        v += length
    if caps and not loop:
        m.poly(rings[0][::-1])
        m.poly(rings[-1])


def slab(m, corners, height, bevel=0.0, sink=0.012, shrink=0.0):
    """A plate laid on the flat polygon corners (counter-clockwise from outside)."""
    c = [Vector(q) for q in corners]
    n = Vector((0, 0, 0))
    for i in range(1, len(c) - 1):
        n += (c[i] - c[0]).cross(c[i + 1] - c[0])
    n.normalize()
    e = (c[1] - c[0]).normalized()
    w = n.cross(e)
    flat = [((q - c[0]).dot(e), (q - c[0]).dot(w)) for q in c]
    if shrink:
        flat = inset(flat, shrink)
    frame = Matrix((e, w, n)).transposed().to_4x4()
    frame.translation = c[0]
    prism(m, flat, -sink, height, frame, (0, bevel), cap0=False)
