"""What belongs to the body below the skirts: tracks, sprockets, idlers, suspension arms.

Links, and the sectors of sprocket and idler, are OBJ groups left_CHAIN_00 ..., in the order in which they follow each
other when the tank drives forward, all alike: Tank Lab moves each towards the place of the next by what the side's
wheels turn. So a pitch is a whole part of a wheel's circumference, of the loop, and of the end wheels.
"""
import math

from mathutils import Vector

from frame import LINK, TRACK_W, TRACK_X, WHEEL_R, WHEEL_Y, WHEEL_Z
from mesh import SIDE, at, new_chart, turn
from shapes import lathe, prism

PITCH = 2 * math.pi * WHEEL_R / 11
LINKS = 69
TEETH = 9
END_Y, END_R = 0.72, TEETH * PITCH / (2 * math.pi)
ACROSS = turn('Y', 90)  # a lathe's axis laid along X


def path(e):
    """The belt's inner line, with the end wheels at z = e and -e, as ('line', a, b) and ('arc', centre, r, from, to) in
    (z, y): from the bottom rear forward, over the idler, back along the top, and around the sprocket."""
    d = Vector((e - WHEEL_Z[0], END_Y - WHEEL_Y))
    phi = math.atan2(d.y, d.x) - math.acos((WHEEL_R - END_R) / d.length)
    down, up = -math.pi / 2, math.pi / 2
    w = WHEEL_Z[0]

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


def end_wheels():
    """Where the end wheels stand so that the loop is LINKS pitches long."""
    lo, hi = 2.9, 3.4
    for _ in range(40):
        middle = (lo + hi) / 2
        lo, hi = (middle, hi) if sum(lengths(path(middle))) < LINKS * PITCH else (lo, middle)
    return lo


IDLER_Z = end_wheels()
LOOP = path(IDLER_Z)


def belt(s, h):
    """The point at arc length s that lies h outside the inner line, as (z, y)."""
    p, n = walk(LOOP, s % (LINKS * PITCH))
    return p + n * h


def slot(k):
    """Where link k begins: they follow each other as the belt runs when the tank drives forward."""
    return (-k - 1) * PITCH


def painted_link():
    """The link whose texture all others share: the one in the middle of the run up to the idler."""
    before = lengths(LOOP)[:3]
    return round(-(sum(before) - before[2] / 2) / PITCH - 0.5) % LINKS


def link_frame():
    """The painted link's own axes: its beginning, the way along it, and the way out, as (z, y)."""
    s = slot(painted_link())
    a, b = belt(s, 0), belt(s + PITCH, 0)
    t = (b - a).normalized()
    return a, t, Vector((t.y, -t.x))


def link(m, k, charts):
    outer, side, inboard, inner, horn = charts
    x0, x1 = TRACK_X - TRACK_W / 2, TRACK_X + TRACK_W / 2

    def on(f, h):
        p = belt(slot(k) + f * PITCH, h)
        return lambda x: (x, p.y, p.x)

    def put(corners, chart):
        """Corners as (point, x, u, v)."""
        m.poly([p(x) for p, x, _, _ in corners], [(u, v) for _, _, u, v in corners], chart)
        m.faces[-1].copy = k != painted_link()
        m.faces[-1].tris = [(0, i, i + 1) for i in range(1, len(corners) - 1)]  # the same cut for each link

    profile = [(0.0, LINK - 0.045), (0.14, LINK), (0.86, LINK), (1.0, LINK - 0.045)]
    rim = [(on(f, h), f * PITCH, h) for f, h in profile]
    i0, i1 = (on(0.0, 0.0), 0.0, 0.0), (on(1.0, 0.0), PITCH, 0.0)
    m.begin('track', 3.0, smooth=25)
    for (a, u, _), (b, v, _) in zip(rim, rim[1:]):
        put([(a, x1, 0, u), (b, x1, 0, v), (b, x0, TRACK_W, v), (a, x0, TRACK_W, u)], outer)
    m.begin('track', 4.0, smooth=25)
    for quad in (rim, [i0, rim[0], rim[3], i1]):
        put([(p, x1, u, h) for p, u, h in quad[::-1]], side)
    m.begin('track', 1.5, smooth=25)
    put([(i0[0], x0, 0, 0), (i1[0], x0, 0, PITCH), (i1[0], x1, TRACK_W, PITCH), (i0[0], x1, TRACK_W, 0)], inner)
    m.begin('track', 1.0, smooth=25)
    flank = [i0, (on(0.0, LINK), 0.0, LINK), (on(1.0, LINK), PITCH, LINK), i1]
    put([(p, x0, u, h) for p, u, h in flank], inboard)
    m.begin('track', 1.0, smooth=25)  # the horn that runs between a wheel's two tyres
    b0, b1, tip, w = on(0.2, 0.004), on(0.8, 0.004), on(0.5, -0.085), 0.028
    foot = [(b0, TRACK_X - w), (b1, TRACK_X - w), (b1, TRACK_X + w), (b0, TRACK_X + w)]
    for (p, x), (q, y) in zip(foot, foot[1:] + foot[:1]):
        put([(p, x, 0, 0), (q, y, 0.12, 0), (tip, TRACK_X, 0.06, 0.09)], horn)


def track(m):
    charts = [new_chart() for _ in range(5)]
    for k in range(LINKS):
        m.group = 'left_track_%02d' % k
        link(m, k, charts)
    m.group = ''


def about(z):
    """The turn of an end wheel at z by k pitches of the belt, forward."""
    return lambda k: at(0, END_Y, z) @ turn('X', 360 / TEETH * k) @ at(0, -END_Y, -z)


def sector(m, profile, f, segments=1, start=0.0):
    lathe(m, profile, TEETH * segments, f, math.radians(start - 180 / TEETH), made=segments)


def sprocket(m):
    z = -IDLER_Z
    f = at(0, END_Y, z) @ ACROSS
    # a tooth where two links meet: the belt comes from below, `slot` counts from its beginning there
    start = sum(lengths(LOOP)[:5])
    joint = math.ceil(start / PITCH) * PITCH
    p = belt(joint, 0)
    tooth = math.degrees(math.atan2(p.y - END_Y, z - p.x))

    def one():
        def on(degrees, r, x):
            a = math.radians(tooth + degrees)
            return f @ Vector((r * math.cos(a), r * math.sin(a), x))

        half = 180 / TEETH
        outline = [(-half, 0.268), (-10, 0.268), (-4, 0.350), (4, 0.350), (10, 0.268), (half, 0.268)]
        m.begin('metal', 2.0, smooth=30)
        m.poly([on(a, r, 1.705) for a, r in [(-half, 0.19)] + outline + [(half, 0.19)]])
        for (a, r), (b, q) in zip(outline, outline[1:]):
            m.poly([on(a, r, 1.65), on(b, q, 1.65), on(b, q, 1.705), on(a, r, 1.705)])
        m.begin(dens=2.2, smooth=45)
        sector(m, [(0.215, 1.68), (0.205, 1.722), (0.11, 1.700), (0.085, 1.728), (0.0, 1.730)], f, 1, tooth)

    m.wheel_of(one, TEETH, about(z), 'sprocket')
    m.begin('metal', 0.5, smooth=40)
    lathe(m, [(0.0, 1.085), (0.28, 1.09), (0.28, 1.13), (0.20, 1.16), (0.20, 1.66)], 8, f)


def idler(m):
    f = at(0, END_Y, IDLER_Z) @ ACROSS

    def one():
        m.begin('paint', 1.6, smooth=40)
        rim = [(0.0, 1.15), (0.29, 1.165), (0.29, 1.60), (0.26, 1.61), (0.235, 1.575), (0.10, 1.555)]
        sector(m, rim, f, 2)
        m.begin('paint', 1.8, smooth=62)
        sector(m, [(0.12, 1.54), (0.10, 1.628), (0.0, 1.636)], f)

    m.wheel_of(one, TEETH, about(IDLER_Z), 'idler')


def arms(m):
    m.begin('paint', 0.4, smooth=20)
    for z in WHEEL_Z:
        arm = [(0.66, z + 0.30), (0.56, z + 0.36), (WHEEL_Y - 0.07, z - 0.05), (WHEEL_Y + 0.08, z - 0.03)]
        prism(m, arm, 1.015, 1.12, SIDE, cap0=False)


def build(m):
    def side():
        track(m)
        sprocket(m)
        idler(m)
        arms(m)

    m.both(side)
