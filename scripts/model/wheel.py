"""One road wheel: two tyres, the groove between them painted; +X is the good side."""
import math

from mathutils import Vector

from frame import WHEEL_R
from mesh import Mesh, turn
from shapes import lathe

RIM = 0.283  # where rubber ends and paint begins, for the texture


def build():
    m = Mesh('tankwheel')
    f = turn('Y', 90)
    n = 14
    r = WHEEL_R
    m.begin('wheel', 2.0, smooth=40)
    lathe(
        m,
        [
            (0.0, -0.19),
            (r, -0.25),
            (r, 0.232),
            (0.283, 0.25),
            (0.262, 0.192),
            (0.10, 0.226),
        ],
        n,
        f,
    )
    m.begin('wheel', 2.2, smooth=40)
    lathe(m, [(0.122, 0.21), (0.104, 0.240), (0.0, 0.248)], 6, f)
    for k in range(5):  # ribs, so that one sees it turn
        a = 2 * math.pi * (k + 0.25) / 5
        c, s = math.cos(a), math.sin(a)

        def on(rr, w, t):
            return f @ Vector((rr * c - w * s, rr * s + w * c, t))

        m.begin('wheel', 1.8, smooth=20)
        in0, in1 = on(0.085, -0.026, 0.236), on(0.085, 0.026, 0.236)
        out0, out1 = on(0.268, -0.018, 0.218), on(0.268, 0.018, 0.218)
        b0, b1 = on(0.085, -0.038, 0.205), on(0.085, 0.038, 0.205)
        c0, c1 = on(0.268, -0.030, 0.18), on(0.268, 0.030, 0.18)
        m.poly([in0, out0, out1, in1])
        m.poly([b0, c0, out0, in0])
        m.poly([c1, b1, in1, out1])
    return m
