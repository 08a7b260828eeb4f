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
    """Each face follows what it is made of, and counts backwards to it: so like faces are like lines, and the whole
    compresses to two thirds of what it takes with indices from the beginning."""
    counts, index, lines, seen, group = [0, 0, 0], {}, [], set(), ''

    def number_of(kind, text):
        tag = ('v', 'vt', 'vn')[kind]
        if (tag, text) not in index:
            counts[kind] += 1
            index[tag, text] = counts[kind]
            lines.append(tag + ' ' + text)
        return index[tag, text]

    def written(corner):
        return '/'.join('' if i is None else str(i - n - 1) for i, n in zip(corner, counts))

    for f in sorted(mesh.faces, key=lambda f: f.group):  # those of no group first
        if f.group != group:
            group = f.group
            lines.append('g ' + group)
        corners = []
        for i, q in enumerate(f.p):
            v = number_of(0, ' '.join(number(c, 3) for c in q))
            vt = number_of(1, ' '.join(number(c / size, 4) for c in f.uv[i])) if size else None
            vn = number_of(2, ' '.join(number(c, 3) for c in normals[id(f)][i]))
            corners.append((v, vt, vn))
        for tri in f.tris:
            ids = [corners[i][0] for i in tri]
            if len(set(ids)) < 3 or frozenset(ids) in seen:
                continue
            seen.add(frozenset(ids))
            lines.append('f ' + ' '.join(written(corners[i]) for i in tri))
    with open(path, 'w', newline='\n') as out:
        out.write('# made by scripts/model_tank\no %s\n' % mesh.name)
        out.write('\n'.join(lines) + '\n')


def read_obj(path):
    """Reads what write_obj writes; indices are 1-based afterwards. `group` has each face's."""
    data, group = {'v': [], 'vt': [], 'vn': [], 'f': [], 'group': []}, ''
    for line in open(path):
        w = line.split()
        if w and w[0] in ('v', 'vt', 'vn'):
            data[w[0]].append(tuple(float(x) for x in w[1:]))
        elif w and w[0] == 'g':
            group = w[1]
        elif w and w[0] == 'f':
            counts = [len(data[t]) for t in ('v', 'vt', 'vn')]
            data['f'].append([tuple(n + 1 + int(x) if x else 0 for x, n in zip(c.split('/'), counts)) for c in w[1:]])
            data['group'].append(group)
    return data
