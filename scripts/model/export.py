"""Normals, and the OBJ writer and reader."""
import math

from mathutils import Vector

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
