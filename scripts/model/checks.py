"""What must hold of the files as written: counts, bounds, winding, flicker, silhouettes, weight."""
import gzip
import math
import os

import numpy as np
from mathutils import Matrix, Vector
from mathutils.bvhtree import BVHTree

from export import read_obj
from frame import CUPOLA, HALF_LENGTH, HALF_WIDTH, MG_TRUNNION, TRACK_X, TRUNNION, TURRET, WHEEL_R, WHEEL_Y, WHEEL_Z
from frame import trunnion_in_machine_gun
from mesh import at, turn

NAMES = ('tankbody', 'tankturret', 'tankmaingun', 'tanksecondarygun', 'tankwheel')
LIMIT_BYTES = 247000
WHEELS = 14
BOUNDS = {  # (low corner, high corner, slack): what the program relies on
    'tankbody': ((-HALF_WIDTH, 0.0, -HALF_LENGTH), (HALF_WIDTH, None, HALF_LENGTH), 0.03),
    'tankwheel': ((-0.25, -WHEEL_R, -WHEEL_R), (0.25, WHEEL_R, WHEEL_R), 0.013),
    'tankmaingun': ((None, None, None), (None, None, 6.3), 0.02),
}


GAP = 0.004  # parallel faces that look the same way keep at least this distance


def machine_gun_in_turret(yaw, pitch):
    back = [-c for c in trunnion_in_machine_gun()]
    return at(*CUPOLA) @ turn('Y', yaw) @ at(*MG_TRUNNION) @ turn('X', -pitch) @ at(*back)


def places(yaw=0.0, pitch=0.0, mg=0.0, mg_pitch=0.0):
    """Where the parts stand in a pose: (mesh, matrix)."""
    t = at(*TURRET) @ turn('Y', yaw)
    out = [('tankbody', Matrix())]
    out += [(NAMES[4], at(s * TRACK_X, WHEEL_Y, z) @ turn('Y', 90 - 90 * s)) for s in (1, -1) for z in WHEEL_Z]
    out += [('tankturret', t), ('tankmaingun', t @ at(*TRUNNION) @ turn('X', -pitch) @ at(*[-c for c in TRUNNION]))]
    return out + [('tanksecondarygun', t @ machine_gun_in_turret(mg, mg_pitch))]


def flicker(every, pose):
    """Faces of the assembled tank, of one part or of two, that lie so close that depth cannot tell them apart."""
    points, faces, names = [], [], []
    for name, matrix in places(*pose):
        d, base = every[name], len(points)
        points += [matrix @ Vector(p) for p in d['v']]
        for f in d['f']:
            faces.append([base + c[0] - 1 for c in f])
            names.append(name)
    tree = BVHTree.FromPolygons(points, faces, all_triangles=True)
    out = []
    for i, f in enumerate(faces):
        p = [points[k] for k in f]
        n = (p[1] - p[0]).cross(p[2] - p[0])
        if n.length < 1e-4:
            continue
        n.normalize()
        for w in ((0.34, 0.33, 0.33), (0.7, 0.15, 0.15), (0.15, 0.7, 0.15), (0.15, 0.15, 0.7)):
            q = p[0] * w[0] + p[1] * w[1] + p[2] * w[2]
            start, far = q - n * 0.0008, GAP
            for _ in range(4):
                hit, hn, k, dist = tree.ray_cast(start, n, far)
                if hit is None:
                    break
                if k != i and hn.dot(n) > 0.985:
                    gap = (hit - q).length * 1000
                    out.append('%s and %s %.1f mm apart at (%.3f, %.3f, %.3f)' % (names[i], names[k], gap, *q))
                    break
                start, far = hit + n * 0.00002, far - dist - 0.00002
                if far <= 0:
                    break
    return sorted(set(out))


def chains(d):
    """What is wrong with the groups that Tank Lab moves: links of a chain have the same corners in the same order."""
    links, out = {}, []
    for f, group in zip(d['f'], d['group']):
        if group:
            links.setdefault(group, []).extend(f)
    forms = {}
    for group, corners in links.items():
        seen = {}
        form = tuple((seen.setdefault(v, len(seen)), vt) for v, vt, _ in corners)
        first = forms.setdefault(group.rsplit('_', 1)[0], (group, form))
        if first[1] != form:
            out.append('%s is not made like %s' % (group, first[0]))
    return out


# of turret, main gun, machine gun's yaw and its pitch, degrees
POSES = ((0, 0, 0, 0), (37, 20, 25, 30), (90, -9, 90, -10), (180, 0, 120, 60))


def clearance(every):
    """Where in its range the machine gun cuts the turret, or loses the rail: only its drum may touch that."""
    turret, gun = every['tankturret'], every['tanksecondarygun']

    def tree(d, matrix):
        return BVHTree.FromPolygons(
            [matrix @ Vector(p) for p in d['v']], [[c[0] - 1 for c in f] for f in d['f']], all_triangles=True
        )

    t = trunnion_in_machine_gun()
    of_drum = [
        all(math.hypot(d['v'][c[0] - 1][1] - t[1], d['v'][c[0] - 1][2] - t[2]) < 0.091 for c in f)
        for d in (gun,)
        for f in gun['f']
    ]
    roof = tree(turret, Matrix())
    for yaw in range(-120, 121, 8):
        for pitch in range(-10, 61, 5):
            cuts = roof.overlap(tree(gun, machine_gun_in_turret(yaw, pitch)))
            if any(not of_drum[g] for _, g in cuts):
                yield 'the machine gun at %d, %d cuts the turret' % (yaw, pitch)
            if not cuts:
                yield 'the machine gun at %d, %d floats' % (yaw, pitch)


# (turned about Y, raised) degrees: where the eye is, and the pose it looks at
VIEWS = {
    'side': (90, 0, POSES[0]),
    'front': (0, 0, POSES[0]),
    'top': (0, 90, POSES[0]),
    'quarter': (40, 10, POSES[0]),
    'rear quarter': (140, 15, POSES[0]),
    'quarter, turned': (40, 10, POSES[1]),
    'side, turned': (90, 5, POSES[2]),
    'rear': (180, 0, POSES[0]),
    'other side': (270, 3, POSES[0]),
    'nearly front': (20, 3, POSES[0]),
    'front, from above': (0, 45, POSES[0]),
    'side, from above': (65, 30, POSES[0]),
    'rear, from above': (200, 40, POSES[0]),
    'right quarter': (300, 15, POSES[0]),
    'rear, turned': (160, 5, POSES[1]),
    'turret back': (250, 8, POSES[3]),
    'front, turned': (10, 20, POSES[2]),
}
FEW_PERCENT = 5.0


def shadow(every, low, yaw, pitch, pose):
    """The silhouette of the assembled tank from afar, in cells of a centimetre."""
    cell, half = 0.01, 8.0
    n = int(2 * half / cell)
    out = np.zeros((n, n), bool)
    eye = turn('Y', yaw) @ turn('X', -pitch)
    flat = np.array((eye.inverted()).to_3x3())[:2]
    for name, matrix in places(*pose):
        d = every[name + low]
        v = np.array(d['v']) @ np.array(matrix.to_3x3()).T + np.array(matrix.translation)
        g = (v @ flat.T + half) / cell
        for f in d['f']:
            a, b, c = (g[k[0] - 1] for k in f)
            det = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            if det < 1e-9:  # seen from behind: what is in front of it covers it
                continue
            lo = np.floor(np.minimum(np.minimum(a, b), c)).astype(int)
            hi = np.ceil(np.maximum(np.maximum(a, b), c)).astype(int)
            x, y = np.meshgrid(np.arange(lo[0], hi[0]) + 0.5, np.arange(lo[1], hi[1]) + 0.5)
            u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / det
            w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / det
            out[lo[1] : hi[1], lo[0] : hi[0]] |= (u >= 0) & (w >= 0) & (u + w <= 1)
    return out


def silhouettes(every):
    """How much of the high silhouette's area the low one differs in, by view: (name, percent, low over high)."""
    for name, view in VIEWS.items():
        a, b = shadow(every, '', *view), shadow(every, 'Low', *view)
        yield name, 100.0 * (a ^ b).sum() / a.sum(), b.sum() / a.sum()


def check(folder, texture):
    """Returns the report's lines and the list of what is wrong."""
    report, bad, total = [], [], {'': 0, 'Low': 0}
    weight = len(gzip.compress(open(texture, 'rb').read(), 9, mtime=0)) if texture else 0
    report.append('%-24s %6s triangles %7d bytes gzipped' % (os.path.basename(texture or 'no texture'), '', weight))
    every = {}
    for low in ('', 'Low'):
        for base in NAMES:
            path = os.path.join(folder, base + low + '.obj')
            d = every[base + low] = read_obj(path)
            z = len(gzip.compress(open(path, 'rb').read(), 9, mtime=0))
            weight += z
            total[low] += len(d['f']) * (WHEELS if base == 'tankwheel' else 1)
            lo = [min(p[i] for p in d['v']) for i in range(3)]
            hi = [max(p[i] for p in d['v']) for i in range(3)]
            report.append(
                '%-24s %6d triangles %7d bytes gzipped  x %.2f..%.2f y %.2f..%.2f z %.2f..%.2f'
                % (base + low, len(d['f']), z, lo[0], hi[0], lo[1], hi[1], lo[2], hi[2])
            )
            for n in d['vn']:
                if abs(math.sqrt(sum(c * c for c in n)) - 1) > 0.002:
                    bad.append('%s%s: normal %s is not of unit length' % (base, low, n))
            if not all(math.isfinite(c) for t in ('v', 'vt', 'vn') for p in d[t] for c in p):
                bad.append('%s%s: a number is not finite' % (base, low))
            if bool(low) == bool(d['vt']):
                bad.append('%s%s: texture coordinates' % (base, low))
            seen = set()
            for f in d['f']:
                p = [Vector(d['v'][c[0] - 1]) for c in f]
                g = (p[1] - p[0]).cross(p[2] - p[0])
                if g.length < 2e-6:
                    bad.append('%s%s: degenerate %s' % (base, low, [tuple(q) for q in p]))
                    continue
                n = sum((Vector(d['vn'][c[2] - 1]) for c in f), Vector((0, 0, 0)))
                if g.dot(n) <= 0:
                    bad.append('%s%s: winding against normals at %s' % (base, low, tuple(p[0])))
                k = frozenset(c[0] for c in f)
                if k in seen:
                    bad.append('%s%s: doubled face at %s' % (base, low, tuple(p[0])))
                seen.add(k)
            limit = BOUNDS.get(base)
            if limit:
                slack = limit[2] * (4 if low else 1)
                for i in range(3):
                    for want, have in ((limit[0][i], lo[i]), (limit[1][i], hi[i])):
                        if want is not None and abs(want - have) > slack:
                            bad.append('%s%s: bound %d is %.3f, wants %.3f' % (base, low, i, have, want))
    report.append('assembled: %d triangles, low %d; all gzipped %d bytes' % (total[''], total['Low'], weight))
    if not 6000 <= total[''] <= 12000:
        bad.append('high set has %d triangles' % total[''])
    if total['Low'] > 700:
        bad.append('low set has %d triangles' % total['Low'])
    bad += chains(every['tankbody'])
    bad += clearance(every)
    for pose in POSES:
        bad += ['turret, guns at %s: %s' % (pose, line) for line in flicker(every, pose)]
    for name, differs, ratio in silhouettes(every):
        report.append('silhouette, %-16s %4.1f %% differs, low/high area %.3f' % (name + ':', differs, ratio))
        if differs > FEW_PERCENT:
            bad.append('the low silhouette, %s, differs' % name)
    if weight > LIMIT_BYTES:
        bad.append('%d bytes gzipped are too many' % weight)
    return report, bad
