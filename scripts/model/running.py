"""What belongs to the body below the skirts: tracks, sprockets, idlers, rollers, suspension arms."""
import math

from mathutils import Vector

from frame import LINK, TRACK_W, TRACK_X, WHEEL_R, WHEEL_Y, WHEEL_Z
from mesh import SIDE, at, new_chart, turn
from shapes import drum, lathe, prism

IDLER_Z, END_Y, END_R = 3.12, 0.72, 0.30
ACROSS = turn('Y', 90)  # a lathe's axis laid along X


def path():
    """The belt's inner line as ('line', a, b) and ('arc', centre, r, from, to) in (z, y), from the
    bottom rear forward, over the idler, back along the top, and around the sprocket."""
    d = Vector((IDLER_Z - WHEEL_Z[0], END_Y - WHEEL_Y))
    phi = math.atan2(d.y, d.x) - math.acos((WHEEL_R - END_R) / d.length)
    down, up = -math.pi / 2, math.pi / 2
    w, e = WHEEL_Z[0], IDLER_Z

    def on(cz, cy, r, a):
        return Vector((cz + r * math.cos(a), cy + r * math.sin(a)))

    return [
        ('line', Vector((-w, WHEEL_Y - WHEEL_R)), Vector((w, WHEEL_Y - WHEEL_R))),
        ('arc', (w, WHEEL_Y), WHEEL_R, down, phi),
        ('line', on(w, WHEEL_Y, WHEEL_R, phi), on(e, END_Y, END_R, phi)),
        ('arc', (e, END_Y), END_R, phi, up),
        ('line', Vector((e, END_Y + END_R)), Vector((-e, END_Y + END_R))),
        ('arc', (-e, END_Y), END_R, up, math.pi - phi),
        ('line', on(-e, END_Y, END_R, math.pi - phi), on(-w, WHEEL_Y, WHEEL_R, math.pi - phi)),
        ('arc', (-w, WHEEL_Y), WHEEL_R, math.pi - phi, math.pi * 1.5),
    ]


def lengths(segments):
    return [(s[2] - s[1]).length if s[0] == 'line' else s[2] * (s[4] - s[3]) for s in segments]


def walk(segments, s):
    """Point and outward normal at arc length s."""
    for seg, length in zip(segments, lengths(segments)):
        if s > length:
            s -= length
            continue
        if seg[0] == 'line':
            t = (seg[2] - seg[1]).normalized()
            return seg[1] + t * s, Vector((t.y, -t.x))
        a = seg[3] + s / seg[2]
        n = Vector((math.cos(a), math.sin(a)))
        return Vector(seg[1]) + n * seg[2], n
    return walk(segments, 0)


def track(m):
    seg = path()
    total = sum(lengths(seg))
    count = round(total / 0.21)
    pitch = total / count
    top0 = sum(lengths(seg)[:4])
    top1 = top0 + lengths(seg)[4]
    x0, x1 = TRACK_X - TRACK_W / 2, TRACK_X + TRACK_W / 2
    outer, side0, side1, inner, horn, roofed = (new_chart() for _ in range(6))
    groove = LINK - 0.026
    painted, fresh = set(), set()  # charts that earlier links have drawn, and this link's own

    def at_s(s, h):
        p, n = walk(seg, s % total)
        return p + n * h

    def put(pts, uv, chart):
        m.poly(pts, uv, chart)
        m.faces[-1].copy = chart in painted
        fresh.add(chart)

    s = 0.0
    k = 0
    while k < count:
        s = k * pitch
        hidden = s > top0 + 0.25 and s + pitch < top1 - 0.25
        n = 1
        if hidden:  # under the skirts a plain slab, several links long
            n = min(6, int((top1 - 0.25 - s) / pitch))
            n = max(n, 1)
        span = n * pitch
        st = (
            [(0.0, LINK - 0.004), (1.0, LINK - 0.004)]
            if hidden
            else [(0.0, groove), (0.13, LINK), (0.87, LINK), (1.0, groove)]
        )
        o = [at_s(s + f * span, h) for f, h in st]
        i0, i1 = at_s(s, 0), at_s(s + span, 0)
        m.begin('dark' if hidden else 'track', 0.5 if hidden else 1.6, smooth=25)
        for (a, b), (f, _), (g, _) in zip(zip(o, o[1:]), st, st[1:]):
            put(
                [(x0, a.y, a.x), (x0, b.y, b.x), (x1, b.y, b.x), (x1, a.y, a.x)][::-1],
                [(0, f * pitch), (0, g * pitch), (TRACK_W, g * pitch), (TRACK_W, f * pitch)][::-1],
                roofed if hidden else outer,
            )
        m.begin('track', 0.8, smooth=25)
        put(
            [(x0, i0.y, i0.x), (x0, i1.y, i1.x), (x1, i1.y, i1.x), (x1, i0.y, i0.x)],
            [(0, 0), (0, pitch), (TRACK_W, pitch), (TRACK_W, 0)],
            inner,
        )
        m.begin('track', 1.6, smooth=25)
        ring = [i0] + o + [i1]
        suv = [(0, 0)] + [(f * pitch, h) for f, h in st] + [(pitch, 0)]
        put([(x1, p.y, p.x) for p in ring][::-1], suv[::-1], side1)
        flank, fuv = ring, suv
        if hidden or s + pitch < lengths(seg)[0]:  # lying on the ground it needs no grooves towards the hull
            high = st[0][1] if hidden else LINK
            flank, fuv = (i0, at_s(s, high), at_s(s + span, high), i1), [(0, 0), (0, LINK), (pitch, LINK), (pitch, 0)]
        put([(x0, p.y, p.x) for p in flank], fuv, side0)
        if s + pitch < lengths(seg)[0]:
            m.begin('track', 0.8, smooth=25)
            b0, b1, tip = at_s(s + 0.22 * span, 0.004), at_s(s + 0.78 * span, 0.004), at_s(s + 0.5 * span, -0.085)
            w, x = 0.028, TRACK_X
            c = [(x - w, b0.y, b0.x), (x - w, b1.y, b1.x), (x + w, b1.y, b1.x), (x + w, b0.y, b0.x)]
            t = (x, tip.y, tip.x)
            for q in range(4):
                put([c[q], c[(q + 1) % 4], t], [(0, 0), (0.09, 0), (0.045, 0.09)], horn)
        painted |= fresh
        k += n


def sprocket(m):
    f = at(0, END_Y, -IDLER_Z) @ ACROSS
    m.begin('metal', smooth=30)
    teeth = []
    n = 10
    for i in range(n):
        a = 2 * math.pi * i / n
        for da, r in ((-0.16, 0.285), (-0.075, 0.362), (0.075, 0.362), (0.16, 0.285)):
            teeth.append((r * math.cos(a + da), r * math.sin(a + da)))
    prism(m, teeth, 1.655, 1.705, f, cap0=False)
    m.begin(smooth=40)
    lathe(m, [(0.215, 1.68), (0.205, 1.722), (0.11, 1.700), (0.085, 1.728), (0.0, 1.730)], 9, f)
    m.begin('metal', 0.5, smooth=40)
    lathe(m, [(0.0, 1.085), (0.28, 1.09), (0.28, 1.13), (0.20, 1.16), (0.20, 1.66)], 8, f)
    m.begin('paint', 0.5, smooth=40)
    lathe(m, [(0.24, 1.0), (0.20, 1.10)], 8, f)


def idler(m):
    f = at(0, END_Y, IDLER_Z) @ ACROSS
    m.begin('paint', smooth=40)
    lathe(
        m,
        [
            (0.0, 1.15),
            (0.298, 1.165),
            (0.298, 1.345),
            (0.21, 1.38),
            (0.298, 1.415),
            (0.298, 1.60),
            (0.26, 1.61),
            (0.235, 1.575),
            (0.10, 1.555),
        ],
        11,
        f,
    )
    m.begin('paint', smooth=62)
    lathe(m, [(0.12, 1.54), (0.10, 1.628), (0.0, 1.636)], 7, f)


def arms(m):
    for z in WHEEL_Z:
        m.begin('paint', 0.4, smooth=20)  # a trailing arm
        arm = [
            (0.66, z + 0.30),
            (0.56, z + 0.36),
            (WHEEL_Y - 0.07, z + 0.05),
            (WHEEL_Y - 0.04, z - 0.07),
            (WHEEL_Y + 0.08, z - 0.03),
        ]
        prism(m, arm, 1.015, 1.12, SIDE)
    for z in (1.2, -0.4, -2.0):
        m.begin('metal', 0.4, smooth=40)
        drum(m, 0.10, 1.0, 1.60, 6, at(0, END_Y + END_R - 0.102, z) @ ACROSS, cap0=False)


def build(m):
    def side():
        track(m)
        sprocket(m)
        idler(m)
        arms(m)

    m.both(side)
