"""The main gun in turret coordinates, and the machine gun in its own shifted frame."""
from mathutils import Vector

from frame import TRUNNION, trunnion_in_machine_gun
from mesh import SIDE, Mesh, at, turn
from shapes import box, disc, drum, lathe, prism, rect, stack, tube

UP = turn('X', -90)


def octagon(w, h, c):
    return rect(-w, -h, w, h, c)


def main_gun():
    m = Mesh('tankmaingun')
    x, y, z = TRUNNION
    f = at(0, y, 0)
    m.begin(smooth=40)  # the drum that keeps the slot closed at every elevation
    drum(m, 0.31, -0.405, 0.405, 18, at(x, y, z) @ turn('Y', 90), 0.0)
    m.begin(smooth=25)  # the mantlet's armoured nose
    stack(
        m,
        [
            (octagon(0.335, 0.235, 0.07), 1.36),
            (octagon(0.335, 0.235, 0.07), 1.60),
            (octagon(0.30, 0.205, 0.07), 1.66),
            (octagon(0.215, 0.175, 0.09), 1.86),
            (octagon(0.19, 0.155, 0.085), 1.885),
        ],
        f,
        cap0=False,
    )
    m.begin('metal', smooth=20)  # coaxial machine gun, telescope
    drum(m, 0.032, 1.60, 1.80, 6, at(0.235, y + 0.10, 0), 0.0, cap0=False, cap1=False)
    m.begin('dark')
    disc(m, 0.032, 1.80, 6, at(0.235, y + 0.10, 0))
    m.begin(smooth=20)
    box(m, (-0.30, -0.08, 1.54), (-0.18, 0.05, 1.645), 0.01, frame=at(0, y + 0.21, 0))
    # sleeve, evacuator, sleeve, muzzle
    m.begin('barrel', 1.2, smooth=40)
    b = at(0, y, 0)
    lathe(
        m,
        [
            (0.150, 1.87),
            (0.150, 1.97),
            (0.122, 2.02),
            (0.106, 2.12),
            (0.104, 2.74),
            (0.113, 2.76),
            (0.113, 2.81),
            (0.103, 2.83),
            (0.102, 3.50),
            (0.146, 3.60),
            (0.150, 4.18),
            (0.100, 4.32),
        ],
        12,
        b,
    )
    m.begin('barrel', 1.2, smooth=40)
    lathe(
        m,
        [
            (0.100, 4.32),
            (0.098, 5.0),
            (0.107, 5.02),
            (0.107, 5.07),
            (0.097, 5.09),
            (0.094, 6.06),
            (0.102, 6.09),
            (0.102, 6.285),
            (0.094, 6.30),
            (0.064, 6.30),
            (0.060, 6.02),
        ],
        12,
        b,
    )
    m.begin('dark')
    disc(m, 0.0605, 6.02, 12, b)
    m.begin('barrel', smooth=20)  # muzzle reference mirror
    box(m, (-0.035, 0.0, 6.15), (0.035, 0.055, 6.24), 0.012, frame=at(0, y + 0.092, 0))
    return m


def machine_gun():
    """What pitches: cradle, gun and box. Mesh origin: below the trunnion, on the plane of the cupola's pivot.

    The cradle rides on the cupola's rail with a drum about the trunnion, which touches the rail at any pitch."""
    m = Mesh('tanksecondarygun')
    t = trunnion_in_machine_gun()
    m.begin('metal', smooth=50)
    drum(m, 0.090, -0.078, 0.078, 8, at(*t) @ turn('Y', 90), 0.0)
    m.begin('metal')
    for s in (1, -1):  # cradle cheeks
        prism(
            m,
            [(t[1] - 0.03, t[2] - 0.05), (t[1] - 0.03, t[2] + 0.05), (t[1] + 0.09, t[2] + 0.09)]
            + [(t[1] + 0.09, t[2] - 0.09)],
            s * 0.058 - 0.008,
            s * 0.058 + 0.008,
            SIDE,
        )
    gun(m, at(0, t[1] + 0.07, t[2] + 0.14))
    return m


def gun(m, f):
    """The gun itself and its box, in a frame on the bore's axis."""
    m.begin('gunmetal', smooth=25)
    box(m, (-0.045, -0.065, -0.36), (0.045, 0.055, 0.08), 0.014, frame=f, bottom=True)
    m.begin('gunmetal')
    box(m, (-0.040, 0.05, -0.20), (0.040, 0.082, 0.06), 0.012, frame=f)
    box(m, (-0.012, 0.05, -0.315), (0.012, 0.10, -0.285), 0.005, frame=f)
    m.begin('gunmetal', 1.2, smooth=40)
    lathe(
        m,
        [
            (0.040, 0.06),
            (0.040, 0.12),
            (0.034, 0.34),
            (0.020, 0.36),
            (0.018, 0.92),
            (0.028, 0.94),
            (0.030, 1.04),
            (0.014, 1.04),
            (0.012, 0.98),
        ],
        7,
        f,
    )
    m.begin('dark')
    disc(m, 0.0122, 0.98, 7, f)
    m.begin('gunmetal')
    box(m, (-0.007, 0.03, 0.28), (0.007, 0.085, 0.31), 0.003, frame=f)

    def put(*points):
        return [f @ Vector(p) for p in points]

    for s in (1, -1):  # spade grips
        grip = put((s * 0.022, 0.03, -0.355), (s * 0.075, 0.045, -0.42), (s * 0.075, -0.045, -0.43))
        tube(m, grip + put((s * 0.022, -0.045, -0.355)), 0.013, 4, caps=False)
    # ammunition box on the left with its feed
    m.begin('crate', smooth=20)
    box(m, (0.085, -0.13, -0.14), (0.20, 0.02, 0.14), 0.008, cut=0.01, frame=f, bottom=True, top=False)
    box(m, (0.080, 0.016, -0.145), (0.205, 0.034, 0.145), 0.008, frame=f)
    m.begin('metal')
    bracket = [(-0.06, -0.05), (-0.03, -0.05), (-0.03, 0.02), (-0.06, 0.02)]
    prism(m, bracket, 0.04, 0.09, f @ SIDE, cap0=False, cap1=False)
    m.begin('brass')
    feed = put((0.13, 0.03, -0.03), (0.115, 0.075, -0.03), (0.07, 0.078, -0.03), (0.035, 0.045, -0.03))
    tube(m, feed, 0.021, 4, caps=False)
