"""Normals, the OBJ writer, and the checks made on what was written."""
import gzip
import math
import os

from mathutils import Vector

from frame import HALF_LENGTH, HALF_WIDTH, WHEEL_R
from mesh import key


def corner_normals(mesh):
    """Per face, one unit normal per corner: faces of a part that meet within its smoothing angle
    share it, the larger face pulling harder, so a big plate stays flat and its bevel turns."""
    at = {}
    for f in mesh.faces:
        for q in f.p:
            at.setdefault((f.part, key(q)), []).append(f)
    out = {}
    for f in mesh.faces:
        ns = []
        limit = math.cos(math.radians(f.smooth))
        for q in f.p:
            n = Vector((0, 0, 0))
            for g in at[(f.part, key(q))]:
                if g.n.dot(f.n) >= limit - 1e-6:
                    n += g.n * g.area
            n.normalize()
            ns.append(n if n.dot(f.n) > 0.2 else f.n)
        out[id(f)] = ns
    return out


def number(x, digits):
    s = '%.*f' % (digits, x)
    if '.' in s:
        s = s.rstrip('0').rstrip('.')
    return '0' if s in ('-0', '') else s


def write_obj(mesh, normals, path, size=None):
    v, vt, vn, lines, seen = {}, {}, {}, [], set()

    def index(table, text):
        return table.setdefault(text, len(table) + 1)
    for f in mesh.faces:
        corners = []
        for i, q in enumerate(f.p):
            a = index(v, ' '.join(number(c, 3) for c in q))
            n = index(vn, ' '.join(number(c, 3) for c in normals[id(f)][i]))
            if size:
                t = index(vt, ' '.join(number(c / size, 4) for c in f.uv[i]))
                corners.append((a, '%d/%d/%d' % (a, t, n)))
            else:
                corners.append((a, '%d//%d' % (a, n)))
        for tri in f.tris:
            ids = [corners[i][0] for i in tri]
            if len(set(ids)) < 3 or frozenset(ids) in seen:
                continue
            seen.add(frozenset(ids))
            lines.append('f ' + ' '.join(corners[i][1] for i in tri))
    with open(path, 'w', newline='\n') as out:
        out.write('# made by scripts/model_tank\no %s\n' % mesh.name)
        for tag, table in (('v', v), ('vt', vt), ('vn', vn)):
            out.writelines('%s %s\n' % (tag, text) for text in table)
        out.write('\n'.join(lines) + '\n')


def read_obj(path):
    data = {'v': [], 'vt': [], 'vn': [], 'f': []}
    for line in open(path):
        w = line.split()
        if w and w[0] in ('v', 'vt', 'vn'):
            data[w[0]].append(tuple(float(x) for x in w[1:]))
        elif w and w[0] == 'f':
            data['f'].append([tuple(int(x) if x else 0 for x in c.split('/')) for c in w[1:]])
    return data


WHEELS = 14
BOUNDS = {     # (low corner, high corner, slack): what the program relies on
    'tankbody': ((-HALF_WIDTH, 0.0, -HALF_LENGTH), (HALF_WIDTH, None, HALF_LENGTH), 0.03),
    'tankwheel': ((-0.25, -WHEEL_R, -WHEEL_R), (0.25, WHEEL_R, WHEEL_R), 0.013),
    'tankmaingun': ((None, None, None), (None, None, 6.3), 0.02),
}


def check(folder, texture):
    """Returns the report's lines and the list of what is wrong."""
    report, bad, total = [], [], {'': 0, 'Low': 0}
    weight = len(gzip.compress(open(texture, 'rb').read(), 9, mtime=0)) if texture else 0
    report.append('%-24s %6s triangles %7d bytes gzipped' % (os.path.basename(texture or 'no texture'), '', weight))
    for low in ('', 'Low'):
        for base in ('tankbody', 'tankturret', 'tankmaingun', 'tanksecondarygun', 'tankwheel'):
            path = os.path.join(folder, base + low + '.obj')
            d = read_obj(path)
            z = len(gzip.compress(open(path, 'rb').read(), 9, mtime=0))
            weight += z
            total[low] += len(d['f']) * (WHEELS if base == 'tankwheel' else 1)
            lo = [min(p[i] for p in d['v']) for i in range(3)]
            hi = [max(p[i] for p in d['v']) for i in range(3)]
            report.append('%-24s %6d triangles %7d bytes gzipped  x %.2f..%.2f y %.2f..%.2f z %.2f..%.2f'
                          % (base + low, len(d['f']), z, lo[0], hi[0], lo[1], hi[1], lo[2], hi[2]))
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
    if weight > 250 * 1024:
        bad.append('%d bytes gzipped are too many' % weight)
    return report, bad
