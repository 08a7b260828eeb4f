"""The hull without its running gear: plates, skirts, engine deck, and everything bolted on."""
import math

from mathutils import Vector

from frame import DECK, GLACIS, glacis, yz
import running
import stowage
from mesh import FRONT, SIDE, Mesh, at, turn
from shapes import box, disc, drum, lathe, prism, rect, slab, stack, tube

UP = turn('X', -90)  # a lathe's axis turned up: local z is world Y


def plates(m):
    m.begin(smooth=25)
    upper = yz(
        (-3.70, 1.16),
        (-3.64, 1.57),
        (-3.60, 1.60),
        (1.85, 1.60),
        (3.60, glacis(3.60)),
        (3.62, 1.10),
        (3.58, 1.06),
        (2.95, 1.16),
    )
    edge = yz(
        (-3.70, 1.16),
        (-3.645, 1.50),
        (-3.60, 1.53),
        (1.835, 1.53),
        (3.55, glacis(3.55) - 0.05),
        (3.57, 1.075),
        (3.56, 1.06),
        (2.95, 1.16),
    )
    stack(m, [(edge, -1.69), (upper, -1.62), (upper, 1.62), (edge, 1.69)], SIDE)
    m.begin(dens=0.8, smooth=25)
    tub = yz(
        (-3.52, 0.70),
        (-3.30, 0.48),
        (2.98, 0.48),
        (3.64, 0.88),
        (3.74, 1.00),
        (3.75, 1.04),
        (3.70, 1.085),
        (3.40, 1.10),
        (2.60, 1.30),  # inside the upper hull, so that nothing shows between the two
        (-3.60, 1.30),
    )
    prism(m, tub, -1.03, 1.03, SIDE, (0.03, 0.03))


def skirts(m):
    """One side: six panels, the first two thick, cut away over the idler and the sprocket."""
    cuts = [3.42, 2.30, 1.16, 0.02, -1.12, -2.26, -3.40]
    for i in range(6):
        z1, z0 = cuts[i] - 0.012, cuts[i + 1] + 0.012
        heavy = i < 2
        low, top = 0.50, 1.425
        if i == 0:
            shape = yz(
                (z0, low),
                (z1 - 0.34, low),
                (z1, low + 0.34),
                (z1, glacis(z1) - 0.045),
                (2.41, glacis(2.41) - 0.045),
                (2.37, top),
                (z0, top),
            )
        elif i == 5:
            shape = yz((z0, 0.98), (z0 + 0.24, 0.86), (z1 - 0.30, 0.72), (z1, low + 0.04), (z1, top), (z0, top))
        else:
            shape = yz((z0, low + 0.04), (z0 + 0.04, low), (z1 - 0.04, low), (z1, low + 0.04), (z1, top), (z0, top))
        m.begin(dens=1.3, smooth=20)
        prism(m, shape, 1.732, 1.78 if heavy else 1.762, SIDE, (0, 0.016))
        if heavy:  # lifting eyes
            box(m, (1.745, top - 0.08, z0 + 0.04), (1.768, top + 0.03, z0 + 0.10), 0.008)
    # the shelf that carries them closes the view down to the tracks
    m.begin()
    prism(
        m,
        yz(
            (-3.62, 1.40),
            (-3.62, 1.447),
            (2.34, 1.447),
            (3.50, glacis(3.50) - 0.022),
            (3.50, glacis(3.50) - 0.05),
            (2.34, 1.40),
        ),
        1.64,
        1.752,
        SIDE,
        cap0=False,
    )
    # mud guards
    m.begin('rubber')
    prism(
        m,
        yz((3.50, 1.09), (3.61, 1.085), (3.70, 0.98), (3.72, 0.84), (3.705, 0.84), (3.68, 0.97), (3.59, 1.05)),
        1.036,
        1.70,
        SIDE,
    )
    prism(m, yz((-3.62, 1.18), (-3.685, 1.18), (-3.70, 0.80), (-3.68, 0.80)), 1.036, 1.70, SIDE)


def grille(m, x0, x1, z0, z1, bars, across=True):
    """A framed grille on the deck: dark bed, slanted slats."""
    y = DECK
    m.begin('dark', 0.6)
    m.poly([(x0, y + 0.006, z0), (x0, y + 0.006, z1), (x1, y + 0.006, z1), (x1, y + 0.006, z0)])
    m.begin(smooth=20)
    t, h = 0.035, 0.045
    box(m, (x0 - t, y - 0.01, z0 - t), (x1 + t, y + h, z0))
    box(m, (x0 - t, y - 0.01, z1), (x1 + t, y + h, z1 + t))
    box(m, (x0 - t, y - 0.01, z0 - 0.002), (x0, y + h - 0.004, z1 + 0.002))
    box(m, (x1, y - 0.01, z0 - 0.002), (x1 + t, y + h - 0.004, z1 + 0.002))
    m.begin(dens=0.7, smooth=20)
    lo, hi = (z0, z1) if across else (x0, x1)
    step = (hi - lo) / bars
    for i in range(bars):
        a = lo + step * (i + 0.12)
        b = a + step * 0.62
        if across:
            top = [
                (x0 - 0.004, y + 0.018, a),
                (x0 - 0.004, y + 0.036, b),
                (x1 + 0.004, y + 0.036, b),
                (x1 + 0.004, y + 0.018, a),
            ]
            face = [top[1], (x0 - 0.004, y + 0.002, b), (x1 + 0.004, y + 0.002, b), top[2]]
        else:
            top = [
                (a, y + 0.018, z1 + 0.004),
                (b, y + 0.036, z1 + 0.004),
                (b, y + 0.036, z0 - 0.004),
                (a, y + 0.018, z0 - 0.004),
            ]
            face = [top[1], (b, y + 0.002, z1 + 0.004), (b, y + 0.002, z0 - 0.004), top[2]]
        m.poly(top)
        m.poly(face)


def engine_deck(m):
    def fan():
        f = at(0.62, DECK, -2.86) @ turn('X', -90)
        m.begin(smooth=40)
        lathe(m, [(0.47, -0.01), (0.46, 0.046), (0.415, 0.046), (0.405, 0.012)], 14, f)
        m.begin('dark')
        disc(m, 0.407, 0.012, 14, f)
        m.begin(dens=0.8, smooth=30)
        lathe(m, [(0.12, 0.0), (0.10, 0.040), (0.0, 0.044)], 7, f)
        for k in range(8):
            a = math.radians(45 * k + 9)
            c, s = math.cos(a), math.sin(a)
            p = [
                f @ Vector((r * c - w * s, r * s + w * c, h))
                for r, w, h in (
                    (0.11, 0.012, 0.034),
                    (0.11, -0.012, 0.034),
                    (0.407, -0.016, 0.040),
                    (0.407, 0.016, 0.040),
                )
            ]
            m.poly(p)

    m.both(fan)
    m.both(lambda: grille(m, 0.36, 1.40, -2.26, -1.86, 6))
    grille(m, -0.20, 0.20, -2.26, -1.86, 4)
    # access plates
    m.begin(smooth=20)
    slab(m, [(-0.10, DECK, -3.48), (-0.10, DECK, -2.40), (0.10, DECK, -2.40), (0.10, DECK, -3.48)], 0.014, 0.008)

    def side():
        m.begin(smooth=20)
        slab(m, [(1.18, DECK, -3.46), (1.18, DECK, -2.42), (1.46, DECK, -2.42), (1.46, DECK, -3.46)], 0.016, 0.01)
        slab(m, [(0.30, DECK, -1.70), (0.30, DECK, -1.20), (1.30, DECK, -1.20), (1.30, DECK, -1.70)], 0.014, 0.01)

    m.both(side, share=False)

    def cap():  # filler cap
        m.begin(dens=0.8)
        drum(m, 0.10, -0.01, 0.045, 7, at(1.30, DECK, -0.92) @ turn('X', -90), 0.015, cap0=False)

    m.both(cap)


def rear(m):
    def lamp():
        m.begin(smooth=20)
        box(m, (1.28, 1.22, -3.76), (1.52, 1.32, -3.66), 0.0, bottom=True)
        m.begin('redlamp')
        m.poly([(1.31, 1.235, -3.765), (1.31, 1.305, -3.765), (1.40, 1.305, -3.765), (1.40, 1.235, -3.765)])
        m.begin('lamp')
        m.poly([(1.42, 1.235, -3.765), (1.42, 1.305, -3.765), (1.49, 1.305, -3.765), (1.49, 1.235, -3.765)])

    def hook():
        m.begin('metal', 0.7, smooth=20)
        shape = yz((-3.50, 0.78), (-3.66, 0.80), (-3.72, 0.86), (-3.72, 0.94), (-3.66, 0.99), (-3.54, 1.00))
        prism(m, shape, 0.62, 0.69, SIDE)
        prism(m, shape, 0.79, 0.86, SIDE)
        drum(m, 0.022, 0.68, 0.80, 4, at(0, 0.90, -3.67) @ turn('Y', 90), cap0=False, cap1=False)

    def exhaust():
        f = at(0.62, 1.38, -3.66) @ turn('Y', 180) @ turn('X', 8)
        m.begin(smooth=20)
        for lo, hi in (((-0.36, -0.13, -0.05), (-0.33, 0.13, 0.055)), ((0.33, -0.13, -0.05), (0.36, 0.13, 0.055))):
            prism(m, rect(lo[0], lo[1], hi[0], hi[1]), lo[2], hi[2], f, (0, 0.006), cap0=False)
        prism(m, rect(-0.362, 0.128, 0.362, 0.158), -0.05, 0.06, f, (0, 0.006), cap0=False)
        prism(m, rect(-0.362, -0.158, 0.362, -0.128), -0.05, 0.06, f, (0, 0.006), cap0=False)
        m.begin('dark')
        m.poly(
            [
                f @ Vector(p)
                for p in ((-0.34, -0.14, 0.012), (0.34, -0.14, 0.012), (0.34, 0.14, 0.012), (-0.34, 0.14, 0.012))
            ]
        )
        m.begin('metal', 0.7, smooth=20)
        for k in range(4):
            y = -0.10 + 0.062 * k
            m.poly(
                [
                    f @ Vector(p)
                    for p in (
                        (-0.335, y - 0.022, 0.05),
                        (0.335, y - 0.022, 0.05),
                        (0.335, y + 0.022, 0.026),
                        (-0.335, y + 0.022, 0.026),
                    )
                ]
            )
            m.poly(
                [
                    f @ Vector(p)
                    for p in (
                        (-0.335, y - 0.022, 0.012),
                        (0.335, y - 0.022, 0.012),
                        (0.335, y - 0.022, 0.05),
                        (-0.335, y - 0.022, 0.05),
                    )
                ]
            )

    m.both(exhaust)
    m.both(lamp)
    m.both(hook)
    m.begin()  # infantry telephone box, and the coupling
    box(m, (0.98, 1.22, -3.78 + 0.03), (1.20, 1.46, -3.60), 0.0, bottom=True)
    m.begin('metal')
    drum(m, 0.06, -3.74, -3.40, 8, at(0, 0.80, 0) @ FRONT, 0.015)


def front(m):
    tilt = math.degrees(math.atan(-GLACIS))

    def light():
        f = at(1.28, glacis(3.30), 3.30)
        m.begin()
        box(m, (-0.16, -0.03, -0.10), (0.16, 0.035, 0.12), 0.01, frame=f)
        m.begin('paint', smooth=40)
        g = f @ at(-0.04, 0.115, 0)
        lathe(m, [(0.0, -0.12), (0.06, -0.10), (0.085, -0.04), (0.085, 0.085)], 8, g)
        m.begin('lamp', smooth=40)
        disc(m, 0.085, 0.085, 8, g)
        m.begin('metal', 0.7)
        tube(
            m,
            [f @ Vector(p) for p in ((-0.15, 0.0, 0.11), (-0.15, 0.20, 0.13), (0.08, 0.20, 0.13), (0.08, 0.0, 0.11))],
            0.012,
            3,
            caps=False,
        )
        m.begin()
        box(m, (0.09, 0.03, -0.06), (0.15, 0.13, 0.06), 0.012, frame=f)

    def hook():
        m.begin('metal', 0.7)
        shape = yz((3.50, 0.74), (3.68, 0.80), (3.735, 0.86), (3.735, 0.92), (3.68, 0.97), (3.60, 0.96))
        prism(m, shape, 0.60, 0.67, SIDE)
        prism(m, shape, 0.75, 0.82, SIDE)
        drum(m, 0.022, 0.66, 0.76, 4, at(0, 0.88, 3.68) @ turn('Y', 90), cap0=False, cap1=False)

    m.both(light)
    m.both(hook)
    # driver's hatch on the right of the deck, three periscopes before it; a splash board
    m.begin(smooth=40)
    f = at(-0.62, glacis(2.20), 2.20) @ turn('X', tilt) @ turn('X', -90)
    lathe(m, [(0.34, -0.03), (0.34, 0.022), (0.315, 0.034), (0.0, 0.046)], 12, f)
    for k, (x, a) in enumerate(((-0.92, 28), (-0.62, 0), (-0.32, -28))):
        g = at(x, glacis(2.58) + (0.02 if k == 1 else 0.03), 2.60 if k == 1 else 2.54) @ turn('X', tilt) @ turn('Y', -a)
        m.begin(dens=0.9)
        box(m, (-0.11, -0.04, -0.07), (0.11, 0.055, 0.05), 0.012, frame=g)
        m.begin('glass')
        m.poly(
            [
                g @ Vector(p)
                for p in ((-0.085, 0.0, 0.055), (0.085, 0.0, 0.055), (0.085, 0.038, 0.055), (-0.085, 0.038, 0.055))
            ]
        )
    m.begin(smooth=20)
    for sx in (1, -1):
        a, b = (0.0, 3.16), (1.02 * sx, 2.86)
        q = [(a[0], glacis(a[1]) - 0.02, a[1]), (b[0], glacis(b[1]) - 0.02, b[1])]
        t = [(a[0], glacis(a[1]) + 0.055, a[1]), (b[0], glacis(b[1]) + 0.055, b[1])]
        back = [(x, y + 0.0, z - 0.03) for x, y, z in q]
        bt = [(x, y + 0.004, z - 0.03) for x, y, z in t]
        loop = [[q[0], t[0], bt[0], back[0]], [q[1], t[1], bt[1], back[1]]]
        if sx > 0:
            loop = [r[::-1] for r in loop]
        for i in range(4):
            j = (i + 1) % 4
            m.poly([loop[0][i], loop[0][j], loop[1][j], loop[1][i]])
        m.poly(loop[1])

    def grousers():  # snow cleats in a rack on the left of the glacis
        m.begin('track', 0.8, smooth=20)
        box(m, (-0.055, -0.01, -0.16), (0.055, 0.035, 0.16))

    places = []
    for k in range(5):
        z = 2.30
        x = 0.30 + 0.15 * k
        places.append(at(x, glacis(z), z) @ turn('X', tilt))
    m.many(grousers, places)
    m.begin(smooth=20)
    z = 2.30
    box(m, (-0.40, -0.01, -0.03), (0.40, 0.048, 0.03), 0.01, frame=at(0.60, glacis(z), z) @ turn('X', tilt))


def build():
    m = Mesh('tankbody')
    plates(m)
    m.both(lambda: skirts(m), share=False)
    # turret ring
    m.begin(smooth=40)
    lathe(m, [(1.10, 1.59), (1.085, 1.64), (1.02, 1.64)], 24, at(0, 0, 0.25) @ UP)
    engine_deck(m)
    rear(m)
    front(m)
    stowage.build(m)
    running.build(m)
    return m
