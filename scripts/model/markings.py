"""What is drawn on surfaces by lines and places: stencilled numbers, a track link, welds and joints."""
import numpy as np

from frame import TRACK_X
from running import PITCH, link_frame


def step(a, b, x):
    t = np.clip((x - a) / (b - a), 0, 1)
    return t * t * (3 - 2 * t)


# ---- stencils: strokes on a 4 x 6 grid
GLYPH = {
    '0': [(0, 1, 0, 5), (4, 1, 4, 5), (1, 0, 3, 0), (1, 6, 3, 6)],
    '1': [(2, 0, 2, 6), (0.8, 4.6, 2, 6)],
    '2': [(0.3, 6, 3, 6), (4, 5, 4, 4), (4, 3.6, 0, 0.6), (0, 0, 4, 0)],
    '3': [(0, 6, 3, 6), (4, 5, 4, 4), (1.2, 3, 3, 3), (4, 2, 4, 1), (0, 0, 3, 0)],
    '4': [(3, 0, 3, 6), (2.4, 5.6, 0, 2.2), (0, 1.8, 4, 1.8)],
    '7': [(0, 6, 4, 6), (4, 5.2, 1.4, 0)],
    '6': [(0, 1, 0, 5), (1, 6, 3.4, 6), (1, 3, 3, 3), (4, 2.4, 4, 0.8), (1, 0, 3, 0)],
    '-': [(1, 3, 3, 3)],
    'T': [(0, 6, 4, 6), (2, 5.2, 2, 0)],
    'L': [(0, 0, 0, 6), (0.8, 0, 4, 0)],
}


def stencil(u, v, text, height):
    """Coverage of the text whose lower left corner is at (0, 0)."""
    unit = height / 6.0
    mask = np.zeros_like(u)
    for k, ch in enumerate(text):
        for x0, y0, x1, y1 in GLYPH.get(ch, []):
            ax, ay, bx, by = (x0 + 5.6 * k) * unit, y0 * unit, (x1 + 5.6 * k) * unit, y1 * unit
            dx, dy = bx - ax, by - ay
            t = np.clip(((u - ax) * dx + (v - ay) * dy) / (dx * dx + dy * dy), 0, 1)
            dist = np.hypot(u - ax - t * dx, v - ay - t * dy)
            mask = np.maximum(mask, 1 - step(0.42 * unit, 0.42 * unit + 0.012, dist))
    return mask


def links(p, flat):
    """The colours of the one painted link: a steel shoe, two rubber pads, end connectors with their pins."""
    a, t, n = link_frame()
    u = ((p[:, 2] - a.x) * t.x + (p[:, 1] - a.y) * t.y) / PITCH
    h = (p[:, 2] - a.x) * n.x + (p[:, 1] - a.y) * n.y
    across = np.abs(np.abs(p[:, 0]) - TRACK_X)
    facing = flat[:, 2] * n.x + flat[:, 1] * n.y
    col = np.broadcast_to(np.array((98, 93, 86.0)), p.shape).copy()
    out, inner, side = facing > 0.9, facing < -0.9, np.abs(flat[:, 0]) > 0.9
    col[np.abs(u - 0.5) > 0.43] = (46, 44, 42)
    col[inner & (across > 0.05) & (across < 0.24)] = (138, 134, 128)  # the wheels polish their two lanes
    shoe = out & (across < 0.25)
    col[shoe] = (112, 106, 98)
    col[shoe & (across > 0.03) & (np.abs(u - 0.5) < 0.27)] = (60, 59, 58)
    col[out & (np.abs(across - 0.25) < 0.008)] = (50, 48, 46)
    connector = out & (across > 0.258)
    col[connector] = (132, 126, 116)
    col[connector & (np.hypot((u - 0.5) * PITCH, across - 0.284) < 0.014)] = (60, 58, 54)
    pin = np.hypot((np.abs(u - 0.5) - 0.27) * PITCH, h - 0.036)
    col[side & (pin < 0.022)] = (58, 55, 52)
    col[side & (pin < 0.015)] = (150, 144, 134)
    return col


def seams(p, n, on):
    """How much of a weld or a panel's joint a point of the hull's upper side has: lines in (x, z)."""
    lines = [
        ((-1.62, 1.80), (1.62, 1.80)),
        ((-1.04, 1.80), (-1.04, 3.50)),
        ((1.04, 1.80), (1.04, 3.50)),
        ((-1.62, -1.10), (1.62, -1.10)),
        ((-1.62, -1.78), (1.62, -1.78)),
        ((-1.62, -2.34), (1.62, -2.34)),
        ((0.22, -3.60), (0.22, -2.34)),
        ((-0.22, -3.60), (-0.22, -2.34)),
    ]
    best = np.full(len(p), 9.0)
    for (ax, az), (bx, bz) in lines:
        dx, dz = bx - ax, bz - az
        t = np.clip(((p[:, 0] - ax) * dx + (p[:, 2] - az) * dz) / (dx * dx + dz * dz), 0, 1)
        best = np.minimum(best, np.hypot(p[:, 0] - ax - t * dx, p[:, 2] - az - t * dz))
    return np.where(on & (n[:, 1] > 0.8), 1 - step(0.008, 0.018, best), 0)
