"""Paint: camouflage, wear, dust, stencils and baked shade for every texel of the atlas."""
import math

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from frame import BOARD, CUPOLA, MG_OFFSET, TURRET, WHEEL_Y, WHEEL_Z, TRACK_X, glacis
from markings import links, seams, stencil, step
from running import END_Y, IDLER_Z as END_Z, TEETH
from wheel import RIM

MATS = [
    'paint',
    'wheel',
    'track',
    'rubber',
    'metal',
    'gunmetal',
    'barrel',
    'dark',
    'glass',
    'lamp',
    'redlamp',
    'canvas',
    'strap',
    'crate',
    'wood',
    'cable',
    'brass',
    'board',
]
COLOUR = {
    'rubber': (58, 57, 56),
    'metal': (98, 100, 95),
    'gunmetal': (72, 74, 78),
    'dark': (38, 38, 37),
    'glass': (42, 58, 74),
    'lamp': (224, 222, 204),
    'redlamp': (176, 40, 32),
    'canvas': (140, 130, 96),
    'strap': (78, 68, 50),
    'crate': (104, 112, 76),
    'wood': (158, 122, 78),
    'cable': (92, 90, 86),
    'brass': (176, 146, 76),
    'track': (112, 106, 98),
    'board': (58, 58, 56),
}
GREEN, BROWN, BLACK = (100, 110, 76), (116, 88, 62), (70, 70, 64)
DUST = np.array((160, 144, 116.0))
WHITE = np.array((224, 222, 208.0))


def noise(p, freq, seed):
    """Smooth value noise in 3D, -1..1."""
    q = p * freq
    i = np.floor(q).astype(np.int64)
    f = q - i
    f = f * f * f * (f * (f * 6 - 15) + 10)
    out = 0.0
    for dx in (0, 1):
        for dy in (0, 1):
            for dz in (0, 1):
                h = (
                    (i[..., 0] + dx) * 374761393
                    + (i[..., 1] + dy) * 668265263
                    + (i[..., 2] + dz) * 2147483647
                    + seed * 974634777
                ) & 0xFFFFFFFF
                h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
                h = ((h ^ (h >> 16)) * 2246822519) & 0xFFFFFFFF
                w = (
                    (f[..., 0] if dx else 1 - f[..., 0])
                    * (f[..., 1] if dy else 1 - f[..., 1])
                    * (f[..., 2] if dz else 1 - f[..., 2])
                )
                out = out + w * (h / 2147483647.5 - 1.0)
    return out


def mix(a, b, t):
    return a + (b - a) * t[..., None]


def camouflage(p):
    """Returns the paint of places on the tank, under wear and shade: patches about two metres wide, as they are put on
    real vehicles. From far away, where a pixel is a hand wide, such patches are still patches, and the low tank's
    corners can carry them; smaller ones would be grains."""
    warp = np.stack([noise(p, 1.1, 3), noise(p, 1.1, 4), noise(p, 1.1, 5)], -1) * 0.35
    q = (p + warp) * np.array((0.62, 0.70, 0.48))
    a = noise(q, 1.15, 11) + 0.2 * noise(q, 2.5, 12)
    b = noise(q + 17.3, 1.05, 13) + 0.2 * noise(q, 2.6, 14)
    camo = np.broadcast_to(np.array(GREEN, float), p.shape)
    camo = mix(camo, np.array(BROWN, float), step(0.07, 0.08, a))
    return mix(camo, np.array(BLACK, float), step(0.27, 0.28, b))


# ---- ambient occlusion
def rays(n):
    """Cosine-weighted directions about +Z, a fixed low-discrepancy set."""
    out = []
    for k in range(n):
        u, phi = (k + 0.5) / n, k * 2.399963
        r = math.sqrt(u)
        out.append((r * math.cos(phi), r * math.sin(phi), math.sqrt(1 - u)))
    return out


def tree(meshes):
    """BVH over (mesh, offset) pairs."""
    v, t = [], []
    for m, off in meshes:
        for f in m.faces:
            base = len(v)
            v += [q + Vector(off) for q in f.p]
            t += [tuple(base + i for i in tri) for tri in f.tris]
    return BVHTree.FromPolygons(v, t, all_triangles=True)


def occlusion(layer, meshes, count):
    body, turret, gun, mg, wheel = meshes
    wheels = [(wheel, (s * TRACK_X, WHEEL_Y, z)) for s in (1, -1) for z in WHEEL_Z]
    off = Vector(TURRET)
    scenes = [
        (tree([(body, (0, 0, 0))] + wheels), tree([(turret, off)]), 0.45, 1.1, True),
        (tree([(turret, (0, 0, 0))]), tree([(body, -off)]), 0.5, 0.9, True),
        (tree([(gun, (0, 0, 0))]), None, 0, 0.4, True),
        (tree([(mg, (0, 0, 0))]), None, 0, 0.2, True),
        (tree([(wheel, (0, 0, 0))]), None, 0, 0.5, False),
    ]
    ao = np.ones(layer['mesh'].shape)
    ys, xs = np.nonzero(layer['mesh'] >= 0)
    group = {}
    for y, x in zip(ys.tolist(), xs.tolist()):
        group.setdefault((int(layer['chart'][y, x]), y >> 1, x >> 1), []).append((y, x))
    dirs = rays(count)
    for (c, gy, gx), texels in group.items():
        y, x = texels[0]
        own, other, weight, reach, ground = scenes[layer['mesh'][y, x]]
        n = Vector(layer['nrm'][y, x])
        flat = Vector(layer['flat'][y, x])
        p = Vector(layer['pos'][y, x]) + flat * 0.006
        turn = ((gx * 73856093) ^ (gy * 19349663)) % 1024 / 1024 * 6.2832
        e = n.orthogonal().normalized()
        w = n.cross(e)
        ct, st = math.cos(turn), math.sin(turn)
        e, w = e * ct + w * st, w * ct - e * st
        blocked = 0.0
        for a, b, h in dirs:
            d = e * a + w * b + n * h
            if d.dot(flat) < 0.02:
                continue
            hit = own.ray_cast(p, d, reach)[3]
            if hit is not None:
                blocked += 1.0 - 0.6 * hit / reach
                continue
            if other:
                hit = other.ray_cast(p, d, reach)[3]
                if hit is not None:
                    blocked += weight * (1.0 - hit / reach)
                    continue
            if ground and d.y < 0:
                blocked += -0.35 * d.y
        value = 1.0 - blocked / len(dirs)
        for t in texels:
            ao[t] = value
    # smooth within charts
    for _ in range(4):
        total, weight = ao.copy(), np.ones_like(ao)
        for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1)):
            same = np.roll(layer['chart'], (dy, dx), (0, 1)) == layer['chart']
            same &= (np.roll(layer['flat'], (dy, dx), (0, 1)) * layer['flat']).sum(-1) > 0.5
            total += np.where(same, np.roll(ao, (dy, dx), (0, 1)), 0)
            weight += same
        ao = total / weight
    return ao


def paint(layer, meshes, count, mats=MATS):
    ok = layer['mesh'] >= 0
    sel = {k: v[ok] for k, v in layer.items()}
    mesh, mat, p, n = sel['mesh'], sel['mat'], sel['pos'], sel['nrm']
    offsets = [
        np.zeros(3),
        np.array(TURRET),
        np.array(TURRET),
        np.array(TURRET) + np.array(CUPOLA) + np.array(MG_OFFSET),
        np.array((0.0, 0.0, 0.0)),
    ]
    tank = p + np.array(offsets)[mesh]

    def is_(name):
        return mat == mats.index(name)

    camo = camouflage(tank)
    col = camo.copy()
    for name, c in COLOUR.items():
        col[is_(name)] = c
    barrel = is_('barrel')
    col[barrel] = camo[barrel]
    # wheels: rubber outside the rim, a hub with bolts, dark lightening holes
    w = is_('wheel')
    r = np.hypot(p[:, 1], p[:, 2])
    col[w] = np.array(GREEN, float) * 0.98
    face = w & (np.abs(p[:, 0]) > 0.15)
    tyre = w & ((r > RIM - 0.004) | (np.abs(p[:, 0]) < 0.09))
    col[tyre & (r > 0.30)] = COLOUR['rubber']
    col[tyre & (r > 0.30) & (np.abs(p[:, 0]) < 0.055)] = (30, 30, 29)
    col[face & tyre] = COLOUR['rubber']
    if w.any():
        for k in range(10):
            t = 2 * math.pi * (k + 0.5) / 10
            d = np.hypot(p[:, 1] - 0.155 * math.sin(t), p[:, 2] - 0.155 * math.cos(t))
            out = face & (p[:, 0] > 0)
            col[out & (d < 0.016)] = (150, 152, 140)
            col[out & (d >= 0.016) & (d < 0.024)] = (66, 72, 50)
        ring = face & (np.abs(r - RIM + 0.012) < 0.010)
        col[ring] = (88, 98, 66)
        hub = face & (r < 0.09) & (p[:, 0] > 0.2)
        for k in range(5):
            t = 2 * math.pi * k / 5
            d = np.hypot(p[:, 1] - 0.06 * math.sin(t), p[:, 2] - 0.06 * math.cos(t))
            col[hub & (d < 0.014)] = (64, 66, 52)
        d = np.hypot(p[:, 1] - 0.02, p[:, 2] - 0.025)
        col[hub & (d < 0.018)] = (170, 60, 44)
    # sprocket and idler hubs: a dark groove and a ring of bolts, one a sector
    end = (
        (mesh == 0)
        & is_('paint')
        & (np.abs(np.abs(p[:, 0]) - 1.62) < 0.112)
        & (np.abs(np.abs(p[:, 2]) - END_Z) < 0.3)
        & (p[:, 1] < 1.05)
    )
    dy, dz = p[:, 1] - END_Y, np.abs(p[:, 2]) - END_Z
    rr = np.hypot(dy, dz)
    turned = np.arctan2(dy, dz)
    bolt = np.hypot(rr - 0.155, (np.mod(turned / (2 * math.pi) * TEETH, 1) - 0.5) * 2 * math.pi * 0.155 / TEETH)
    col[end] = GREEN
    col[end & (np.abs(rr - 0.195) < 0.009)] = (60, 62, 50)
    col[end & (bolt < 0.026)] = (64, 66, 52)
    col[end & (bolt < 0.017)] = (150, 152, 142)
    t = is_('track')
    col[t] = links(p[t], sel['flat'][t])
    # the skirts' lower lip is rubber; the headlamps have a rim and a ribbed lens
    lip = (mesh == 0) & is_('paint') & (np.abs(p[:, 0]) > 1.725) & (np.abs(sel['flat'][:, 0]) > 0.9) & (p[:, 1] < 0.60)
    col[lip] = (70, 70, 66)
    lens = np.hypot(np.abs(p[:, 0]) - 1.24, p[:, 1] - glacis(3.30) - 0.115)
    front = is_('lamp') & (p[:, 2] > 0)
    col[front] = np.array((214, 214, 204.0)) * (0.82 + 0.18 * np.cos(p[front][:, :1] * 2 * math.pi / 0.034))
    col[front & (lens > 0.066)] = (96, 98, 92)
    # variation
    v = 1 + 0.05 * noise(tank, 1.9, 21) + 0.03 * noise(tank, 7.0, 22)
    flatpaint = is_('paint') | barrel | w | is_('crate')
    col = col * np.where(is_('lamp') | is_('glass') | is_('redlamp'), 1.0, v)[:, None]
    soft = is_('canvas')
    col[soft] *= (1 + 0.14 * noise(tank * np.array((3.0, 1, 1)), 6.0, 23))[soft][:, None]
    # anti-slip coating on what one walks on
    walk = is_('paint') & (mesh < 2) & (n[:, 1] > 0.95) & (sel['size'] > 0.25) & (sel['convex'] > 0.05)
    col[walk] *= 0.90
    col = mix(col, col * 0.5, seams(p, n, (mesh == 0) & is_('paint')))
    # bolts along the edges of bolted plates
    facing = (np.abs(sel['flat'][:, 0]) > 0.98) | (sel['flat'][:, 1] > 0.98)
    plate = is_('paint') & (mesh < 2) & facing & (sel['size'] > 0.09) & (sel['size'] < 1.35)
    b1 = np.hypot(sel['convex'] - 0.05, (np.mod(sel['along'] / 0.19, 1) - 0.5) * 0.19)
    col = mix(col, col * 0.62, np.where(plate, 1 - step(0.012, 0.024, b1), 0))
    col = mix(col, col * 1.55, np.where(plate, 1 - step(0.005, 0.012, b1), 0))
    # wear on edges, grime in corners, streaks down the sides, soot at the exhausts
    chip = noise(tank, 6.0, 31) + 0.5 * noise(tank, 19.0, 32)
    wear = flatpaint & (sel['convex'] < 0.016)
    col = mix(col, np.array((150, 148, 134.0)), np.where(wear, 0.12 + 0.34 * step(0.15, 0.7, chip), 0.0))
    col = col * (1 - 0.24 * np.exp(-sel['concave'] / 0.03))[:, None]
    steep = is_('paint') & (np.abs(n[:, 1]) < 0.75) & (mesh < 2)
    streak = step(0.2, 0.7, noise(tank * np.array((7.0, 0.7, 7.0)), 1.0, 33))
    col = mix(col, DUST * 0.8, np.where(steep, 0.20 * streak, 0))
    soot = np.exp(-(((np.abs(tank[:, 0]) - 0.62) / 0.42) ** 2 + ((tank[:, 1] - 1.42) / 0.20) ** 2)) * (
        tank[:, 2] < -3.5
    )
    col = col * (1 - 0.45 * soot * is_('paint') * (mesh == 0))[:, None]
    # dust: low parts, and what faces up
    high = np.where((mesh == 0), step(1.25, 0.30, tank[:, 1]), 0.0)
    dust = np.clip(high * (0.62 + 0.30 * noise(tank, 1.7, 41) + 0.22 * noise(tank, 5.0, 42)), 0, 0.75) * np.where(
        t, 0.35, 0.85
    )
    dust = np.where(w, np.clip(0.20 + 0.2 * noise(p, 6.0, 43), 0, 1), dust)
    up = np.clip(n[:, 1], 0, 1) * np.clip(0.15 + 0.16 * noise(tank, 1.3, 44), 0, 1)
    dust = np.where(is_('lamp') | is_('redlamp') | is_('glass'), 0.05, np.maximum(dust, np.where(w, 0, up)))
    col = mix(col, DUST, dust)
    # rings on the barrel
    for z in (4.62, 4.72, 4.82):
        col = mix(col, WHITE, np.where(barrel & (np.abs(p[:, 2] - z) < 0.018), 0.85, 0))
    # numbers and signs
    flake = np.clip(0.90 + 0.35 * noise(tank, 8.0, 51), 0, 1)

    def letter(on, u, v, text, height, colour=WHITE):
        return mix(col, np.array(colour, float), np.where(on, stencil(u, v, text, height) * flake, 0))

    tur, body = (mesh == 1) & is_('paint'), (mesh == 0) & is_('paint')
    for sign in (1, -1):
        on = tur & (n[:, 0] * sign > 0.5) & (sel['size'] > 0.05)
        u = -(p[:, 2] - 0.455) if sign > 0 else p[:, 2]
        col = letter(on, u, p[:, 1] - 0.485, '327', 0.18)
    for on, side, middle, slope in ((p[:, 2] > 0, 1, 0.9324, 1.302), (p[:, 2] < 0, -1, 1.3009, 1.011)):
        u, v = p[:, 0] * side + BOARD[0] * 0.86, (p[:, 1] - middle) * slope + 0.038
        col = letter(is_('board') & on, u, v, 'TL-327', 0.076)
    du, dv = p[:, 0] + 0.86, -(p[:, 2] - 3.36)
    on = body & (n[:, 1] > 0.8)
    col[on & (np.hypot(du, dv) < 0.115)] = (206, 172, 72)
    col = letter(on, du + 0.072, dv + 0.05, '60', 0.10, (52, 50, 44))
    ao = occlusion(layer, meshes, count)[ok]
    shade = 0.44 + 0.56 * np.clip(ao * 1.12, 0, 1) ** 0.85
    shade = np.where(is_('lamp') | is_('redlamp'), 1.0, shade)
    col = np.clip(col * shade[:, None] * 1.20, 0, 255)
    image = np.zeros(layer['pos'].shape)
    image[ok] = col
    print('texture: average %.0f, %.0f%% of the atlas used, mean AO %.2f' % (col.mean(), 100 * ok.mean(), ao.mean()))
    return bleed(image, ok)


def bleed(image, ok):
    """Grows every chart into the free texels about it."""
    ok = ok.copy()
    for _ in range(4):
        total, weight = np.zeros_like(image), np.zeros(ok.shape)
        for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (1, -1), (-1, 1), (-1, -1)):
            k = np.roll(ok, (dy, dx), (0, 1))
            total += np.where(k[..., None], np.roll(image, (dy, dx), (0, 1)), 0)
            weight += k
        new = ~ok & (weight > 0)
        image[new] = total[new] / weight[new][:, None]
        ok |= new
    return pull_push(image, ok)


def pull_push(image, ok):
    """Fills what is still free with a blur of its surroundings: cheap to compress, harmless in mipmaps."""
    levels = [(image * ok[..., None], ok.astype(float))]
    while levels[-1][0].shape[0] > 1:
        c, w = levels[-1]
        h = c.shape[0] // 2
        levels.append((c.reshape(h, 2, h, 2, 3).sum((1, 3)), w.reshape(h, 2, h, 2).sum((1, 3))))
        levels[-1] = (levels[-1][0] / np.maximum(levels[-1][1], 1)[..., None], np.minimum(levels[-1][1], 1))
    full = levels[-1][0]
    for c, w in levels[-2::-1]:
        full = np.repeat(np.repeat(full, 2, 0), 2, 1)
        full = np.where(w[..., None] > 0, c, full)
    return full


def save(image, path, quality):
    from PIL import Image

    data = np.round(image[::-1]).astype(np.uint8)
    Image.fromarray(data, 'RGB').save(path, 'JPEG', quality=quality, optimize=True, subsampling='4:2:0')


def load(path):
    from PIL import Image

    return np.array(Image.open(path).convert('RGB')).astype(float)[::-1]
