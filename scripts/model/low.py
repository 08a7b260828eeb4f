"""The far tank: the same silhouettes for a few hundred triangles, in the same frames."""
import math

from mathutils import Vector

from corners import add_corners
from frame import CUPOLA, TRACK_W, TRACK_X, TRUNNION, TURRET, WHEEL_R, WHEEL_Z, glacis, trunnion_in_machine_gun, yz
from mesh import SIDE, TOP, Mesh, at
from running import ACROSS, END_R, END_Y, IDLER_Z
from shapes import box, disc, drum, lathe, prism, rect, stack
from turret import BELT, BOTTOM, SHOULDER, UP

MOST = 700  # triangles of the assembled tank


def body():
    m = Mesh('tankbodyLow')
    m.begin()
    prism(
        m,
        yz((-3.74, 1.10), (-3.68, 1.645), (1.85, 1.64), (3.64, glacis(3.62) + 0.022), (3.66, 1.02)),
        -1.69,
        1.69,
        SIDE,
    )
    prism(
        m, yz((-3.52, 0.70), (-3.30, 0.48), (2.98, 0.48), (3.75, 1.02), (3.62, 1.11), (-3.60, 1.17)), -1.03, 1.03, SIDE
    )

    def side():
        m.begin()
        prism(
            m,
            yz(
                (-3.40, 0.98),
                (-2.26, 0.49),
                (3.06, 0.47),
                (3.40, 0.84),
                (3.40, glacis(3.4) - 0.03),
                (2.40, 1.44),
                (-3.40, 1.44),
            ),
            1.66,
            1.775,
            SIDE,
            cap0=False,
        )
        # the track: what hangs out below the skirts, as a thick band with the end wheels' discs within
        x0, x1 = TRACK_X - TRACK_W / 2, TRACK_X + TRACK_W / 2 - 0.01  # not flush with the hull's side
        e, w = IDLER_Z, WHEEL_Z[0]
        o = [(e, 1.09), (e + 0.30, 0.94), (e + 0.37, 0.66), (e + 0.24, 0.43), (w + 0.10, 0.0)]
        i = [(e, 1.01), (e + 0.22, 0.90), (e + 0.28, 0.70), (e + 0.16, 0.46), (w + 0.06, 0.10)]
        o, i = ([(-z, y) for z, y in half] + half[::-1] for half in (o, i))
        m.begin(smooth=20)
        for k in range(len(o) - 1):
            a, b, c, d = o[k], o[k + 1], i[k + 1], i[k]

            def at3(p, x):
                return (x, p[1], p[0])

            m.poly([at3(a, x1), at3(b, x1), at3(b, x0), at3(a, x0)])
            m.poly([at3(d, x1), at3(c, x1), at3(b, x1), at3(a, x1)])
            if 2 < k < 6:  # elsewhere the hull and the end wheels hide what is inside
                m.poly([at3(d, x0), at3(c, x0), at3(c, x1), at3(d, x1)])
                m.poly([at3(a, x0), at3(b, x0), at3(c, x0), at3(d, x0)])
        for z in (-IDLER_Z, IDLER_Z):
            m.begin()
            disc(m, END_R * 1.14, 1.60, 5, at(0, END_Y, z) @ ACROSS)
        m.begin()
        for z, y, s in ((3.715, 0.84, 1), (-3.695, 0.80, -1)):  # mud guards
            flap = [(1.04, y, z), (1.70, y, z), (1.70, 1.14, z - 0.1 * s), (1.04, 1.14, z - 0.1 * s)]
            m.poly(flap if s > 0 else flap[::-1])
            side = [(0.78, 3.56), (0.80, 3.72), (0.99, 3.74), (1.12, 3.56)]  # as far out as the tow hooks
            side = [(1.70, y, z * s) for y, z in side]
            m.poly(side[::-1] if s > 0 else side)

    m.both(side)
    ridge(m, (0.30, glacis(2.60), 2.60), (1.16, glacis(3.02), 3.02), 0.07)  # splash board
    ridge(m, (-1.16, glacis(3.02), 3.02), (-0.30, glacis(2.60), 2.60), 0.07)
    return m


def ridge(m, a, b, height):
    """Stands for what is too narrow for more: a roof of two faces over the way from a to b."""
    a, b = Vector(a), Vector(b)
    across = (b - a).cross(Vector((0, 1, 0))).normalized() * 0.6 * height
    top = Vector((0, height, 0))
    m.begin()
    m.poly([a + across, b + across, b + top, a + top])
    m.poly([b - across, a - across, a + top, b + top])


def turret():
    m = Mesh('tankturretLow')
    m.begin(smooth=20)
    pick = [1, 2, 4, 7]

    def ring(half):
        h = [half[i] for i in pick]
        return [(z, x) for x, z in h + [(-x, z) for x, z in h[::-1]]]

    belt = [(x + 0.03, z) for x, z in BELT]
    stack(m, [(ring(BOTTOM), 0.05), (ring(belt), 0.37), (ring(SHOULDER), 0.815)], TOP)
    m.begin()
    box(m, (-1.10, 0.29, -2.73), (1.10, 0.68, -2.15), bottom=True)
    drum(m, 0.39, 0.80, 0.94, 5, at(CUPOLA[0], 0, CUPOLA[2]) @ UP, cap0=False)
    box(m, (-0.98, 0.78, 0.18), (-0.60, 1.02, 0.72))
    box(m, (-0.24, 0.78, 0.06), (0.04, 1.05, 0.34))
    for x in (1.02, -1.02):
        p = [(x - 0.014, 0.79, -2.088), (x + 0.014, 0.79, -2.088), (x, 0.79, -2.112)]
        t = (x, 2.75, -2.10)
        for i in range(3):
            m.poly([p[i], t, p[(i + 1) % 3]][::-1])

    def smoke():
        foot = [(1.36, 0.52, 0.02), (1.36, 0.52, -0.62), (1.26, 0.76, -0.62), (1.26, 0.76, 0.02)]
        tip = (1.60, 0.68, -0.22)
        for i in range(4):
            m.poly([foot[i], foot[(i + 1) % 4], tip])

    m.both(smoke)
    ridge(m, (0.25, 0.80, -0.62), (0.85, 0.80, -0.62), 0.09)  # the loader's hatch
    return m


def main_gun():
    m = Mesh('tankmaingunLow')
    y = TRUNNION[1]
    m.begin(smooth=20)
    stack(
        m,
        [
            (rect(-0.36, -0.28, 0.36, 0.28), 1.20),
            (rect(-0.33, -0.22, 0.33, 0.22), 1.64),
            (rect(-0.19, -0.15, 0.19, 0.15), 1.89),
        ],
        at(0, y, 0),
        cap0=False,
    )
    m.begin(smooth=70)
    lathe(m, [(0.118, 1.80), (0.112, 6.30)], 5, at(0, y - 0.007, 0), 0.314)
    disc(m, 0.112, 6.30, 5, at(0, y - 0.007, 0), 0.314)
    m.begin(smooth=70)
    lathe(m, [(0.12, 3.46), (0.20, 3.59), (0.20, 4.20), (0.12, 4.34)], 4, at(0, y, 0), math.pi / 4)
    return m


def machine_gun():
    m = Mesh('tanksecondarygunLow')
    t = trunnion_in_machine_gun()
    y, z = t[1] + 0.07, t[2] + 0.14
    m.begin()
    box(m, (-0.05, y - 0.07, z - 0.40), (0.05, y + 0.07, z + 0.10))
    box(m, (0.07, y - 0.13, z - 0.14), (0.20, y + 0.03, z + 0.14))
    box(m, (-0.06, -0.015, t[2] - 0.03), (0.06, y - 0.06, t[2] + 0.03))  # stands for the rail, too
    p = [(0.0, y + 0.032, z + 0.08), (-0.03, y - 0.018, z + 0.08), (0.03, y - 0.018, z + 0.08)]
    q = [(a, b, z + 1.04) for a, b, _ in p]
    for i in range(3):
        m.poly([p[i], p[(i + 1) % 3], q[(i + 1) % 3], q[i]])
    return m


def wheel():
    m = Mesh('tankwheelLow')
    m.begin()  # inside it comes to a point behind the track: nobody sees that
    lathe(m, [(0.0, -0.24), (WHEEL_R * 1.03, 0.24)], 8, ACROSS, math.pi / 8)
    disc(m, WHEEL_R * 1.03, 0.24, 8, ACROSS, math.pi / 8)
    return m


def build(paint):
    """The five meshes, with as many corners for the paint as MOST triangles leave."""
    meshes = [body(), turret(), main_gun(), machine_gun(), wheel()]
    used = [sum(len(f.tris) for f in m.faces) for m in meshes]
    spare = MOST - sum(used[:4]) - len(WHEEL_Z) * 2 * used[4]
    placed = [(meshes[0], (0, 0, 0)), (meshes[1], TURRET), (meshes[2], TURRET)]
    add_corners(placed, spare, paint)
    return meshes
