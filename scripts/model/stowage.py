"""What lies on the hull: tool boxes, the tow cable, pioneer tools, and the boards with its number."""
from frame import BOARD, DECK, glacis
from mesh import TOP
from shapes import box, prism, slab, tube


def boards(m):
    """The number on the bow and the one on the rear plate: thin boards with texels enough to be read."""
    m.begin('board', 3.0)
    for x, low, high in (
        (BOARD[0], (0.8848, 3.6549), (0.9800, 3.7343)),
        (-BOARD[0], (1.2396, -3.6944), (1.3622, -3.6765)),
    ):
        m.poly([(-x, *low), (x, *low), (x, *high), (-x, *high)])


def lie(m):
    def left():
        m.begin(smooth=20)  # tool boxes along the sponson
        slab(m, [(1.40, DECK, -1.10), (1.40, DECK, -0.35), (1.60, DECK, -0.35), (1.60, DECK, -1.10)], 0.03, 0.012)

    m.both(left, share=False)
    # side boxes over the skirts' shelf (outside the turret's sweep only in height)
    # the tow cable, along the left edge of the deck, and its eyes
    m.begin('cable', 0.6)
    x = 1.545
    tube(
        m,
        [
            (1.30, DECK + 0.03, -3.50),
            (x - 0.02, DECK + 0.03, -3.40),
            (x, DECK + 0.022, -3.1),
            (x, DECK + 0.022, -0.2),
            (x + 0.01, DECK + 0.022, 1.5),
            (x, glacis(2.0) + 0.028, 2.0),
            (x - 0.03, glacis(2.75) + 0.024, 2.75),
        ],
        0.02,
        5,
    )
    m.begin('metal')
    for z in (-2.6, -1.4, 0.2, 1.3):
        box(m, (x - 0.045, DECK - 0.01, z - 0.03), (x + 0.045, DECK + 0.048, z + 0.03))
    tube(
        m,
        [
            (x - 0.03, glacis(2.77) + 0.03, 2.77),
            (x - 0.085, glacis(2.87) + 0.03, 2.87),
            (x - 0.05, glacis(2.97) + 0.03, 2.97),
            (x + 0.01, glacis(2.97) + 0.03, 2.97),
            (x + 0.02, glacis(2.87) + 0.03, 2.87),
        ],
        0.016,
        4,
        loop=True,
    )
    # pioneer tools on the right: shovel, axe, crowbar
    m.begin('wood', 0.8)
    tube(m, [(-1.52, DECK + 0.03, -2.3), (-1.52, DECK + 0.03, -3.1)], 0.018, 4)
    tube(m, [(-1.46, DECK + 0.03, 0.9), (-1.46, DECK + 0.03, -0.1)], 0.018, 4)
    m.begin('metal')
    prism(
        m,
        [(-2.32, -1.60), (-2.32, -1.44), (-2.06, -1.44), (-1.96, -1.52), (-2.06, -1.60)],
        DECK + 0.01,
        DECK + 0.045,
        TOP,
        (0, 0.012),
        cap0=False,
    )
    prism(
        m,
        [(0.86, -1.50), (0.98, -1.52), (0.98, -1.34), (0.86, -1.40)],
        DECK + 0.012,
        DECK + 0.048,
        TOP,
        (0, 0.012),
        cap0=False,
    )
    tube(m, [(-1.585, DECK + 0.022, -0.4), (-1.585, DECK + 0.022, 1.3)], 0.014, 3)


def build(m):
    lie(m)
    boards(m)
