"""Builds the ten OBJ files and the texture, then checks what it wrote. Run by scripts/model_tank."""
import os
import sys
import time

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import atlas  # noqa: E402
import checks  # noqa: E402
import corners  # noqa: E402
import exposure  # noqa: E402
import export  # noqa: E402
import frame  # noqa: E402
import guns  # noqa: E402
import hull  # noqa: E402
import low  # noqa: E402
import texture  # noqa: E402
import turret  # noqa: E402
import wheel  # noqa: E402
from mesh import unwrap  # noqa: E402

QUALITY = 84


def run(args):
    rays = 8 if '--quick' in args else 72
    assets = os.path.join(HERE, '..', '..', 'assets')
    folder = os.path.join(assets, 'tankobjs')
    os.makedirs(folder, exist_ok=True)
    began = time.time()
    high = [hull.build(), turret.build(), guns.main_gun(), guns.machine_gun(), wheel.build()]
    for m in high:
        unwrap(m.faces)
    exposure.thin(high)
    scale = atlas.pack(high)
    print('atlas: %.1f texels per metre' % scale)
    normals = [export.corner_normals(m) for m in high]
    for m, n in zip(high, normals):
        export.write_obj(m, n, os.path.join(folder, m.name + '.obj'), atlas.SIZE)
    picture = os.path.join(assets, 'texture.jpg')
    if '--no-texture' not in args:
        every = {}
        for n in normals:
            every.update(n)
        layer = atlas.rasterise(high, every, texture.MATS)
        print('rasterised after %.0f s' % (time.time() - began))
        texture.save(texture.paint(layer, high, rays), picture, QUALITY)
    turret_at, origin = frame.TURRET, (0, 0, 0)
    paint = corners.Paint(list(zip(high[:3], (origin, turret_at, turret_at))), texture.load(picture))
    for m in low.build(paint):
        export.write_obj(m, export.corner_normals(m), os.path.join(folder, m.name + '.obj'))
    report, bad = checks.check(folder, picture if os.path.exists(picture) else None)
    print('\n'.join(report))
    for line in bad[:30]:
        print('WRONG: ' + line)
    print('%s in %.0f s' % ('%d faults' % len(bad) if bad else 'all checks passed', time.time() - began))
    return 1 if bad else 0


sys.exit(run(sys.argv[sys.argv.index('--') + 1 :] if '--' in sys.argv else []))
