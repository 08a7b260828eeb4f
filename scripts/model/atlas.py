"""The atlas: charts packed into one square, and every texel told which point of the tank it shows."""
import math

import numpy as np

SIZE = 1024
PAD = 2
TEXEL = ('mesh', 'mat', 'chart')  # integer layers of the map


def sizes(charts, scale):
    out = {}
    for c, faces in charts.items():
        us = [u for f in faces for u, _ in f.uv]
        vs = [v for f in faces for _, v in f.uv]
        d = max(f.dens for f in faces) * scale
        u0, v0 = min(us), min(vs)
        w, h = (max(us) - u0) * d, (max(vs) - v0) * d
        turned = h > w
        if turned:
            w, h = h, w
        out[c] = (math.ceil(w) + 2 * PAD + 1, math.ceil(h) + 2 * PAD + 1, u0, v0, d, turned)
    return out


def skyline(boxes, size):
    """Bottom-left skyline packing; None when they do not fit."""
    order = sorted(boxes, key=lambda c: (-boxes[c][1], -boxes[c][0], c))
    sky, where = [(0, 0, size)], {}
    for c in order:
        w, h = boxes[c][0], boxes[c][1]
        best = None
        for i in range(len(sky)):
            x, y = sky[i][0], 0
            if x + w > size:
                break
            j, room = i, w
            while room > 0:
                y = max(y, sky[j][1])
                room -= sky[j][2] - (x - sky[j][0] if j == i else 0)
                j += 1
            if y + h <= size and (best is None or (y, x) < best):
                best = (y, x)
        if best is None:
            return None
        y, x = best
        where[c] = (x, y)
        new = []
        for sx, sy, sw in sky:
            if sx + sw <= x or sx >= x + w:
                new.append((sx, sy, sw))
                continue
            if sx < x:
                new.append((sx, sy, x - sx))
            if sx + sw > x + w:
                new.append((x + w, sy, sx + sw - x - w))
        new.append((x, y + h, w))
        new.sort()
        sky = []
        for s in new:
            if sky and sky[-1][1] == s[1]:
                sky[-1] = (sky[-1][0], s[1], sky[-1][2] + s[2])
            else:
                sky.append(s)
    return where


def pack(meshes):
    """Turns every face's uv from metres into texels of the atlas; returns texels per metre."""
    charts = {}
    for m in meshes:
        for f in m.faces:
            charts.setdefault(f.chart, []).append(f)
    lo, hi = 20.0, 220.0
    for _ in range(12):
        mid = (lo + hi) / 2
        lo, hi = (mid, hi) if skyline(sizes(charts, mid), SIZE) else (lo, mid)
    boxes = sizes(charts, lo)
    where = skyline(boxes, SIZE)
    for c, faces in charts.items():
        x, y = where[c]
        _, _, u0, v0, d, turned = boxes[c]
        for f in faces:
            out = []
            for u, v in f.uv:
                a, b = (u - u0) * d, (v - v0) * d
                if turned:
                    a, b = b, boxes[c][1] - 2 * PAD - 1 - a
                out.append((x + PAD + 0.5 + a, y + PAD + 0.5 + b))
            f.uv = out
    return lo


def edges_of(faces):
    """For each face, its sharp edges: [(a, b, convex)]."""
    from mesh import key

    table = {}
    for f in faces:
        k = [key(q) for q in f.p]
        for i in range(len(k)):
            table.setdefault((f.part, min(k[i - 1], k[i]), max(k[i - 1], k[i])), []).append(f)
    out = {}
    for f in faces:
        k = [key(q) for q in f.p]
        mine = []
        for i in range(len(k)):
            others = [g for g in table[(f.part, min(k[i - 1], k[i]), max(k[i - 1], k[i]))] if g is not f]
            if not others:
                continue
            g = others[0]
            if f.n.dot(g.n) > 0.93:
                continue
            mid = sum((q for q in g.p), f.p[0] * 0) / len(g.p)
            mine.append((f.p[i - 1], f.p[i], (mid - f.p[i]).dot(f.n) < 0))
        out[id(f)] = mine
    return out


def rasterise(meshes, normals, mats):
    """Layers over the atlas: position (in the mesh's frame), normal, face normal, ids, distances to
    the nearest convex and concave edge, and the way along that edge."""
    layer = {
        'pos': np.zeros((SIZE, SIZE, 3)),
        'nrm': np.zeros((SIZE, SIZE, 3)),
        'flat': np.zeros((SIZE, SIZE, 3)),
        'convex': np.full((SIZE, SIZE), 9.0),
        'concave': np.full((SIZE, SIZE), 9.0),
        'along': np.zeros((SIZE, SIZE)),
        'size': np.zeros((SIZE, SIZE)),
    }
    for name in TEXEL:
        layer[name] = np.full((SIZE, SIZE), -1, dtype=np.int32)
    for mi, m in enumerate(meshes):
        sharp = edges_of(m.faces)
        for f in m.faces:
            if f.copy:
                continue
            fn = np.array(f.n)
            for tri in f.tris:
                uv = np.array([f.uv[i] for i in tri])
                p = np.array([f.p[i] for i in tri])
                n = np.array([normals[id(f)][i] for i in tri])
                x0, y0 = np.floor(uv.min(0)).astype(int)
                x1, y1 = np.ceil(uv.max(0)).astype(int)
                e = np.array([uv[1] - uv[0], uv[2] - uv[0]])
                det = e[0, 0] * e[1, 1] - e[0, 1] * e[1, 0]
                if abs(det) < 1e-9:
                    continue
                gx, gy = np.meshgrid(np.arange(x0, x1) + 0.5, np.arange(y0, y1) + 0.5)
                dx, dy = gx - uv[0, 0], gy - uv[0, 1]
                b = (dx * e[1, 1] - dy * e[1, 0]) / det
                c = (dy * e[0, 0] - dx * e[0, 1]) / det
                a = 1 - b - c
                tol = -0.02
                hit = (a >= tol) & (b >= tol) & (c >= tol)
                iy, ix = np.nonzero(hit)
                if not len(ix):
                    continue
                w = np.stack([a[iy, ix], b[iy, ix], c[iy, ix]], 1)
                q, ty, tx = w @ p, iy + y0, ix + x0
                layer['pos'][ty, tx] = q
                nn = w @ n
                layer['nrm'][ty, tx] = nn / np.linalg.norm(nn, axis=1, keepdims=True)
                layer['flat'][ty, tx] = fn
                layer['mesh'][ty, tx], layer['mat'][ty, tx], layer['chart'][ty, tx] = mi, mats.index(f.mat), f.chart
                layer['size'][ty, tx] = f.area
                best = {True: np.full(len(ix), 9.0), False: np.full(len(ix), 9.0)}
                along = np.zeros(len(ix))
                for ea, eb, convex in sharp[id(f)]:
                    ea, eb = np.array(ea), np.array(eb)
                    d = eb - ea
                    length = np.linalg.norm(d)
                    t = np.clip((q - ea) @ d / length**2, 0, 1)
                    dist = np.linalg.norm(q - ea - t[:, None] * d, axis=1)
                    closer = dist < best[convex]
                    best[convex] = np.where(closer, dist, best[convex])
                    if convex:
                        along = np.where(closer, (t - 0.5) * length, along)
                layer['convex'][ty, tx], layer['concave'][ty, tx] = best[True], best[False]
                layer['along'][ty, tx] = along
    return layer
