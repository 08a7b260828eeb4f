"""The turret: an arrow-shaped shell, armour modules, bustle rack, and the roof's furniture."""
from mathutils import Vector

from frame import CUPOLA, MG_TRUNNION
from mesh import SIDE, TOP, Mesh, at, turn
from shapes import box, disc, drum, inset, lathe, prism, rect, slab, stack, tube

UP = turn('X', -90)
DOWN = turn('X', 90)
ROOF = 0.80
NOTCH_X, NOTCH_Z = 0.44, 0.89
# half outlines (x, z), front to rear
BOTTOM = [
    (0.44, 1.14),
    (0.55, 1.14),
    (1.08, 0.60),
    (1.12, 0.50),
    (1.08, -0.85),
    (0.97, -1.02),
    (0.90, -1.10),
    (0.80, -1.14),
]
BELT = [
    (0.44, 1.66),
    (0.62, 1.74),
    (1.40, 0.78),
    (1.47, 0.62),
    (1.47, -1.05),
    (1.39, -1.30),
    (1.30, -2.18),
    (1.20, -2.26),
]
SHOULDER = [
    (0.44, 1.20),
    (0.56, 1.20),
    (1.16, 0.62),
    (1.25, 0.50),
    (1.27, -1.02),
    (1.22, -1.25),
    (1.14, -2.14),
    (1.06, -2.20),
]
LEVELS = [
    (0.05, BOTTOM, 0.03),
    (0.08, BOTTOM, 0.0),
    (0.33, BELT, 0.0),
    (0.40, BELT, 0.0),
    (0.765, SHOULDER, 0.0),
    (0.80, SHOULDER, 0.032),
]


def outline(half):
    return half + [(-x, z) for x, z in half[::-1]] + [(-NOTCH_X, NOTCH_Z), (NOTCH_X, NOTCH_Z)]


def shell(m):
    m.begin(smooth=25)
    rings = []
    for y, half, d in LEVELS:
        p = [(z, x) for x, z in outline(half)]
        if d:
            q = inset(p, d)
            p = q[:-2] + p[-2:] if y < 0.1 else q
        rings.append((p, y))
    stack(m, rings, TOP)
    m.begin(dens=0.5)
    box(m, (-0.45, 0.056, 0.80), (0.45, 0.085, 1.14), bottom=True)
    m.begin(dens=0.6, smooth=40)
    lathe(m, [(1.0, -0.02), (1.0, 0.06)], 24, UP)


def band(i, lower, upper, y0, y1):
    """The shell's quad between outline points i and i+1, as (lower i, lower i+1, upper i+1, upper i)."""
    a, b, c, d = lower[i], lower[i + 1], upper[i + 1], upper[i]
    return [Vector((a[0], y0, a[1])), Vector((b[0], y0, b[1])), Vector((c[0], y1, c[1])), Vector((d[0], y1, d[1]))]


def patch(q, u0, u1, v0, v1):
    def on(u, v):
        return (q[0] * (1 - u) + q[1] * u) * (1 - v) + (q[3] * (1 - u) + q[2] * u) * v

    return [on(u0, v0), on(u1, v0), on(u1, v1), on(u0, v1)]


def armour(m):
    cheek = band(1, BELT, SHOULDER, 0.40, 0.765)
    under = band(1, BOTTOM, BELT, 0.08, 0.33)
    side = band(3, BELT, SHOULDER, 0.40, 0.765)

    def build():
        m.begin(dens=1.25, smooth=20)
        slab(m, patch(cheek, 0.02, 0.48, 0.04, 0.93), 0.035, 0.018)
        slab(m, patch(cheek, 0.51, 0.97, 0.04, 0.93), 0.035, 0.018)
        slab(m, patch(under, 0.05, 0.95, 0.25, 0.95), 0.025, 0.014)
        for u0, u1 in ((0.01, 0.42), (0.44, 0.61)):
            m.begin(dens=1.6, smooth=20)
            slab(m, patch(side, u0, u1, 0.03, 0.94), 0.045, 0.02)
        # stowage bins on the bustle's flanks
        flank = band(5, BELT, SHOULDER, 0.40, 0.765)
        m.begin(smooth=20)
        slab(m, patch(flank, 0.04, 0.50, -0.10, 0.92), 0.13, 0.03)
        slab(m, patch(flank, 0.53, 0.96, -0.10, 0.92), 0.13, 0.03)

    m.both(build, share=False)


def smoke(m):
    side = band(3, BELT, SHOULDER, 0.40, 0.765)
    q = patch(side, 0.64, 0.97, 0.1, 0.9)
    centre = (q[0] + q[1] + q[2] + q[3]) / 4

    def bank():
        m.begin(smooth=20)
        slab(m, patch(side, 0.64, 0.97, 0.12, 0.88), 0.05, 0.015)

    m.both(bank)

    def tube1():
        m.begin('metal', 0.9, smooth=40)
        drum(m, 0.040, -0.09, 0.14, 6, cap0=False, cap1=False)
        m.begin('dark', 0.5)
        disc(m, 0.040, 0.14, 6)

    places = []
    for row in range(2):
        for k in range(4):
            p = centre + Vector((0.065 - 0.05 * row, 0.075 - 0.13 * row, 0.19 - 0.125 * k))
            places.append(at(*p) @ turn('Y', 62 - 9 * k) @ turn('X', -24 + 6 * row))
    m.both(lambda: m.many(tube1, places))


def commander(m):
    x, z = CUPOLA[0], CUPOLA[2]
    f = at(x, 0, z) @ UP
    m.begin(smooth=40)
    lathe(m, [(0.43, 0.79), (0.43, 0.825), (0.375, 0.84), (0.355, 0.918), (0.268, 0.918), (0.262, 0.90)], 14, f)
    m.begin(smooth=40)
    lathe(m, [(0.266, 0.895), (0.255, 0.94), (0.0, 0.962)], 14, f)

    def block():
        m.begin(smooth=20)
        box(m, (-0.075, 0.0, -0.03), (0.075, 0.082, 0.045))
        m.begin('glass', 0.8)
        m.poly([(-0.055, 0.022, 0.0495), (0.055, 0.022, 0.0495), (0.055, 0.066, 0.0495), (-0.055, 0.066, 0.0495)])

    m.many(block, [at(x, 0.815, z) @ turn('Y', 22.5 + 45 * k) @ at(0, 0, 0.385) for k in range(8)])
    rail(m, f)


def rail(m, f):
    """The ring on stanchions that the machine gun's carriage runs round: it turns with the turret alone."""
    r = MG_TRUNNION[2]
    m.begin('metal', 0.8, smooth=40)
    section = [(r, 1.092), (r + 0.024, 1.14), (r - 0.024, 1.14), (r, 1.092)]
    lathe(m, section, 14, f)

    def stanchion():
        m.begin('metal', 0.6, smooth=70)
        lathe(m, [(0.020, 0.912), (0.014, 1.112)], 3, UP)

    m.many(stanchion, [f @ turn('Z', 45 + 90 * k) @ at(r, 0, 0) @ DOWN for k in range(4)])


def loader(m):
    x, z = 0.50, -0.38
    f = at(x, 0, z) @ UP
    m.begin(smooth=40)
    lathe(m, [(0.36, 0.79), (0.36, 0.83), (0.335, 0.845), (0.295, 0.845), (0.285, 0.868), (0.0, 0.885)], 12, f)
    m.begin('metal')
    tube(
        m,
        [
            (x - 0.12, 0.86, z - 0.05),
            (x - 0.12, 0.92, z - 0.03),
            (x + 0.10, 0.92, z - 0.03),
            (x + 0.10, 0.86, z - 0.05),
        ],
        0.013,
        4,
        caps=False,
    )
    m.begin('metal')
    box(m, (x - 0.20, 0.79, z - 0.40), (x + 0.20, 0.85, z - 0.30), 0.012)
    m.begin()
    g = at(x + 0.05, 0.80, z + 0.50) @ turn('Y', 14)
    box(m, (-0.10, -0.01, -0.07), (0.10, 0.10, 0.06), frame=g)
    m.begin('glass')
    m.poly(
        [
            g @ Vector(p)
            for p in ((-0.075, 0.03, 0.065), (0.075, 0.03, 0.065), (0.075, 0.08, 0.065), (-0.075, 0.08, 0.065))
        ]
    )


def sights(m):
    # the gunner's main sight: an armoured box behind a cut in the right cheek, doors open
    m.begin(smooth=20)
    x0, x1, z0, z1 = -0.98, -0.60, 0.18, 0.64
    shape = [(0.78, z1 + 0.02), (1.00, z1 - 0.03), (1.02, z1 - 0.06), (1.02, z0 + 0.06), (0.96, z0), (0.78, z0)]
    prism(m, shape, x0, x1, SIDE, (0.025, 0.025))
    m.begin('glass')
    a, b = Vector((0, 0.815, z1 + 0.0115 + 0.006)), Vector((0, 0.965, z1 - 0.0226 + 0.006))
    m.poly([(x0 + 0.07, a.y, a.z), (x1 - 0.07, a.y, a.z), (x1 - 0.07, b.y, b.z), (x0 + 0.07, b.y, b.z)])
    m.begin(smooth=20)
    for xa, xb in ((x0 + 0.03, x0 + 0.06), (x1 - 0.06, x1 - 0.03)):
        box(m, (xa, 0.79, z1 - 0.03), (xb, 0.98, z1 + 0.10), 0.008)
    # the commander's panoramic sight
    f = at(-0.10, 0, 0.20) @ UP
    m.begin(smooth=40)
    lathe(m, [(0.19, 0.79), (0.19, 0.83), (0.15, 0.86), (0.115, 0.89), (0.115, 0.915)], 12, f)
    g = at(-0.10, 0, 0.20) @ turn('Y', -12)
    m.begin(smooth=20)
    prism(m, rect(-0.13, -0.15, 0.14, 0.15, 0.045), 0.905, 1.055, g @ TOP, (0, 0.025))
    m.begin('glass')
    m.poly(
        [
            g @ Vector(p)
            for p in ((-0.085, 0.935, 0.145), (0.085, 0.935, 0.145), (0.085, 1.015, 0.145), (-0.085, 1.015, 0.145))
        ]
    )


def roof(m):
    m.begin(smooth=40)  # ventilator
    lathe(m, [(0.17, 0.79), (0.17, 0.83), (0.12, 0.86), (0.0, 0.868)], 10, at(0.02, 0, -1.35) @ UP)
    m.begin(smooth=20)
    slab(m, [(-0.30, ROOF, -2.02), (-0.30, ROOF, -1.62), (0.34, ROOF, -1.62), (0.34, ROOF, -2.02)], 0.022, 0.01)
    m.begin(smooth=20)
    slab(m, [(0.62, ROOF, -2.02), (0.62, ROOF, -1.16), (1.00, ROOF, -1.16), (1.00, ROOF, -2.02)], 0.018, 0.01)
    slab(m, [(-1.00, ROOF, -2.02), (-1.00, ROOF, -1.16), (-0.62, ROOF, -1.16), (-0.62, ROOF, -2.02)], 0.018, 0.01)
    m.begin(dens=1.1, smooth=20)  # the cover that closes the roof over the gun, clear of it at every elevation
    box(m, (-0.46, 0.768, 0.50), (0.46, 0.816, 1.19), 0.012, bottom=True)

    def lug():
        m.begin(dens=0.8, smooth=20)
        box(m, (1.02, 0.79, 0.28), (1.06, 0.865, 0.40), 0.02)
        box(m, (0.98, 0.79, -1.12), (1.02, 0.865, -1.00), 0.02)

    def antenna():
        m.begin('metal', 0.6, smooth=40)
        f = at(1.02, 0, -2.10) @ UP
        lathe(m, [(0.065, 0.79), (0.036, 0.86), (0.032, 0.99), (0.009, 1.06), (0.006, 2.75), (0.0, 2.76)], 5, f)

    m.both(lug)
    m.both(antenna)
    m.begin('metal', 0.6)  # crosswind sensor
    lathe(
        m,
        [(0.05, 0.79), (0.014, 0.86), (0.012, 1.14), (0.035, 1.15), (0.03, 1.22), (0.0, 1.23)],
        5,
        at(-0.14, 0, -2.13) @ UP,
    )


def rack(m):
    m.begin('metal', 0.6, smooth=40)
    for y in (0.30, 0.50, 0.70):
        r = 0.014 if y == 0.50 else 0.018
        tube(
            m,
            [
                (1.12, y, -2.10),
                (1.10, y, -2.64),
                (1.02, y, -2.72),
                (-1.02, y, -2.72),
                (-1.10, y, -2.64),
                (-1.12, y, -2.10),
            ],
            r,
            3 if y == 0.50 else 4,
            caps=False,
        )
    for x, z in ((1.10, -2.60), (0.55, -2.72), (0.0, -2.72), (-0.55, -2.72), (-1.10, -2.60)):
        tube(m, [(x, 0.285, z), (x, 0.715, z)], 0.015, 4, caps=False)
    m.begin('metal', 0.6)
    box(m, (-1.09, 0.285, -2.70), (1.09, 0.30, -2.02), 0.0, bottom=True)
    m.begin('canvas', 0.8, smooth=50)
    drum(m, 0.115, -0.95, 0.20, 9, at(0, 0.42, -2.56) @ turn('Y', 90), 0.03)
    drum(m, 0.10, -0.90, 0.05, 8, at(0, 0.40, -2.36) @ turn('Y', 90), 0.03)
    drum(m, 0.105, -0.78, 0.10, 8, at(0, 0.585, -2.45) @ turn('Y', 88), 0.03)
    m.begin('strap', 0.8)
    for x in (-0.70, -0.12):
        drum(m, 0.121, x - 0.02, x + 0.02, 9, at(0, 0.42, -2.56) @ turn('Y', 90))
    m.begin('crate', 0.8, smooth=20)
    box(m, (0.28, 0.295, -2.66), (0.66, 0.60, -2.32), 0.02, cut=0.012)
    m.begin('canvas', 0.8, smooth=20)
    box(m, (0.70, 0.295, -2.64), (1.03, 0.66, -2.30), 0.06, cut=0.04)


def build():
    m = Mesh('tankturret')
    shell(m)
    armour(m)
    smoke(m)
    commander(m)
    loader(m)
    sights(m)
    roof(m)
    rack(m)
    return m
