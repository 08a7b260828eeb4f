"""Texels where the eye goes: charts that look at little but other plates get a coarser texture."""
from mathutils import Vector

from frame import CUPOLA, MG_OFFSET, TRACK_X, TURRET, WHEEL_Y, WHEEL_Z
from texture import rays, tree


def thin(meshes):
    body, turret, gun, mg, wheel = meshes
    t = Vector(TURRET)
    offsets = [Vector((0, 0, 0)), t, t, t + Vector(CUPOLA) + Vector(MG_OFFSET), Vector((TRACK_X, WHEEL_Y, WHEEL_Z[3]))]
    placed = list(zip(meshes[:4], offsets)) + [(wheel, (s * TRACK_X, WHEEL_Y, z)) for s in (1, -1) for z in WHEEL_Z]
    scene = tree(placed)
    dirs = rays(24)
    for m, off in zip(meshes, offsets):
        charts = {}
        for f in m.faces:
            charts.setdefault(f.chart, []).append(f)
        for faces in charts.values():
            best, total = 0.0, 0.0
            for f in [g for g in faces if not g.copy][:40]:
                e = f.n.orthogonal().normalized()
                w = f.n.cross(e)
                for tri in f.tris:
                    p = sum((f.p[i] for i in tri), Vector((0, 0, 0))) / 3 + f.n * 0.01 + off
                    free = 0.0
                    for a, b, h in dirs:
                        d = e * a + w * b + f.n * h
                        if scene.ray_cast(p, d, 8.0)[0] is None:
                            free += 1.0 if d.y > -0.1 else 0.25
                    best, total = max(best, free / len(dirs)), total + 1
            k = 0.35 if best < 0.08 else 0.6 if best < 0.3 else 1.0
            if m is wheel:
                k = max(k, 0.6) if best < 0.3 else 1.0
            if all(f.n.y < -0.9 for f in faces):
                k = min(k, 0.3)
            for f in faces:
                f.dens *= k
