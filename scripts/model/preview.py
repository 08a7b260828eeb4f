"""Renders the OBJ files into a contact sheet under /tmp, to look at: blender -b -P preview.py -- NAME [VIEW ...]."""
import math
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import bpy  # noqa: E402
from mathutils import Matrix, Vector  # noqa: E402

from export import read_obj  # noqa: E402
from frame import CUPOLA, MG_OFFSET, TRACK_X, TRUNNION, TURRET, WHEEL_Y, WHEEL_Z  # noqa: E402
from mesh import at, turn  # noqa: E402

ASSETS = os.path.join(HERE, '..', '..', 'assets')
ZUP = Matrix.Rotation(math.pi / 2, 4, 'X')  # our Y up into Blender's Z up


SUN = Vector((0.45, -0.45, 0.77)).normalized()


def material(name, image, lit=True):
    """The program's own shading: texture times (ambient + diffuse), no shadows; back faces are magenta."""
    mat = bpy.data.materials.new(name)
    mat.use_nodes = True
    nt = mat.node_tree
    nt.nodes.clear()

    def node(kind, **inputs):
        n = nt.nodes.new(kind)
        for k, v in inputs.items():
            n.inputs[int(k[1:])].default_value = v
        return n

    def wire(a, i, b, j):
        nt.links.new(a.outputs[i], b.inputs[j])

    geo = node('ShaderNodeNewGeometry')
    dot = node('ShaderNodeVectorMath', _1=SUN)
    dot.operation = 'DOT_PRODUCT'
    wire(geo, 'Normal', dot, 0)
    amount = node('ShaderNodeMath', _1=0.72)
    amount.operation, amount.use_clamp = 'MULTIPLY', True
    wire(dot, 'Value', amount, 0)
    total = node('ShaderNodeMath', _1=0.48 if lit else 1.0)
    total.operation = 'ADD'
    if lit:
        wire(amount, 0, total, 0)
    good = node('ShaderNodeEmission', _0=(0.44, 0.48, 0.34, 1))
    wire(total, 0, good, 1)
    if image:
        image.colorspace_settings.name = 'Non-Color'
        tex = node('ShaderNodeTexImage')
        tex.image = image
        wire(tex, 'Color', good, 0)
    bad, sw, out = (
        node('ShaderNodeEmission', _0=(1, 0, 1, 1)),
        node('ShaderNodeMixShader'),
        node('ShaderNodeOutputMaterial'),
    )
    wire(geo, 'Backfacing', sw, 0)
    wire(good, 0, sw, 1)
    wire(bad, 0, sw, 2)
    wire(sw, 0, out, 0)
    return mat, good


def load(name, mat):
    d = read_obj(os.path.join(ASSETS, 'tankobjs', name + '.obj'))
    me = bpy.data.meshes.new(name)
    me.from_pydata(d['v'], [], [[c[0] - 1 for c in f] for f in d['f']])
    me.use_auto_smooth = True
    if d['vt']:
        layer = me.uv_layers.new()
        for i, c in enumerate(c for f in d['f'] for c in f):
            layer.data[i].uv = d['vt'][c[1] - 1]
    me.normals_split_custom_set([d['vn'][c[2] - 1] for f in d['f'] for c in f])
    me.materials.append(mat)
    return me


def place(meshes, yaw, pitch, mg, where=Matrix()):
    made = []

    def put(i, m):
        o = bpy.data.objects.new('x', meshes[i])
        o.matrix_world = ZUP @ where @ m
        bpy.context.collection.objects.link(o)
        made.append(o)

    put(0, Matrix())
    t = at(*TURRET) @ turn('Y', yaw)
    put(1, t)
    put(2, t @ at(*TRUNNION) @ turn('X', -pitch) @ at(*[-c for c in TRUNNION]))
    put(3, t @ at(*CUPOLA) @ turn('Y', mg) @ at(*MG_OFFSET))
    for s in (1, -1):
        for k, z in enumerate(WHEEL_Z):
            put(4, at(s * TRACK_X, WHEEL_Y, z) @ (turn('Y', 180) if s < 0 else Matrix()) @ turn('X', 17 * k))
    return made


# name: (eye, target, lens, yaw, pitch, mg)
VIEWS = {
    'front_left': ((7.5, 3.0, 8.5), (0, 1.1, 1.0), 45, 0, 0, 0),
    'left': ((12, 2.2, 1.0), (0, 1.2, 1.0), 45, 0, 0, 0),
    'front': ((0.6, 2.2, 12), (0, 1.3, 0), 60, 0, -9, 20),
    'rear_left': ((6.5, 3.2, -8.5), (0, 1.1, 0), 45, 0, 0, 0),
    'rear_right': ((-6.5, 2.8, -8.0), (0, 1.1, 0), 45, 60, 20, -70),
    'right': ((-12, 1.8, 0.5), (0, 1.2, 0.5), 45, 0, 20, 120),
    'top': ((2.5, 11, -1.0), (0, 1.0, 0.8), 40, 0, 0, 40),
    'back180': ((7.0, 4.5, -8.0), (0, 1.2, -1.0), 45, 180, -4, 0),
    'low_front': ((3.6, 0.35, 6.0), (0.4, 1.0, 1.5), 40, 60, -9, 0),
    'wheels': ((4.2, 0.75, 1.9), (1.4, 0.7, 1.5), 40, 0, 0, 0),
    'idler': ((3.4, 0.9, 4.9), (1.2, 0.75, 3.0), 45, 0, 0, 0),
    'sprocket': ((3.6, 1.3, -5.0), (1.2, 0.9, -3.0), 45, 0, 0, 0),
    'turret_left': ((4.6, 3.4, 3.2), (0.2, 2.1, 0.8), 50, 0, 0, 0),
    'turret_roof': ((-2.6, 4.6, 2.6), (-0.1, 2.4, 0.2), 50, 0, 20, -30),
    'bustle': ((3.0, 3.6, -5.2), (0.1, 2.1, -1.2), 50, 0, 0, 0),
    'mantlet': ((1.9, 2.6, 4.2), (0.1, 2.0, 1.5), 50, 0, 20, 0),
    'gap': ((3.2, 1.9, 2.6), (0.5, 1.72, 0.4), 55, 40, 0, 0),
    'mg': ((-2.2, 3.2, 1.3), (-0.55, 2.75, 0.15), 65, 0, 0, 0),
    'engine': ((1.8, 4.0, -5.6), (0, 1.5, -2.6), 45, 120, 10, 0),
    'glacis': ((1.6, 3.0, 6.2), (0.0, 1.2, 2.6), 45, 60, 0, 0),
    'under': ((2.2, 0.12, 5.4), (0.6, 0.7, 2.0), 40, 0, 0, 0),
    'lods': ((16, 5.0, 15), (0, 1.0, 0), 45, 20, 5, 0),
    'lods_side': ((24, 2.5, 0), (0, 1.0, 0), 50, 0, 0, 0),
    'low_close': ((7.5, 3.0, 8.5), (0, 1.1, 1.0), 45, 0, 0, 0),
}


def main(args):
    name, wanted = args[0], args[1:] or list(VIEWS)
    big = '--big' in wanted
    wanted = [w for w in wanted if not w.startswith('--')]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = 'CYCLES'
    scene.cycles.samples = 9
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.render.resolution_x, scene.render.resolution_y = (1280, 800) if big else (640, 400)
    scene.view_settings.view_transform = 'Raw'
    scene.render.threads_mode, scene.render.threads = 'FIXED', 2
    world = bpy.data.worlds.new('w')
    scene.world = world
    world.use_nodes = True
    world.node_tree.nodes['Background'].inputs[0].default_value = (0.62, 0.70, 0.78, 1)
    ground = bpy.data.meshes.new('g')
    ground.from_pydata([(-60, -60, 0), (60, -60, 0), (60, 60, 0), (-60, 60, 0)], [], [[0, 1, 2, 3]])
    gm, shader = material('ground', None, False)
    shader.inputs[0].default_value = (0.58, 0.55, 0.47, 1)
    shader.inputs[1].default_value = 1.0
    ground.materials.append(gm)
    scene.collection.objects.link(bpy.data.objects.new('g', ground))
    path = os.path.join(ASSETS, 'texture.jpg')
    mat, _ = material('tank', bpy.data.images.load(os.path.abspath(path)) if os.path.exists(path) else None)
    plain, _ = material('plain', None)
    names = ('tankbody', 'tankturret', 'tankmaingun', 'tanksecondarygun', 'tankwheel')
    high, low = [load(n, mat) for n in names], [load(n + 'Low', plain) for n in names]
    camera = bpy.data.objects.new('cam', bpy.data.cameras.new('cam'))
    scene.collection.objects.link(camera)
    scene.camera = camera
    from PIL import Image

    shots = []
    for w in wanted:
        eye, target, lens, yaw, pitch, mg = VIEWS[w]
        made = []
        if w.startswith('lods'):
            made += place(high, yaw, pitch, mg, at(0, 0, 5) if w == 'lods_side' else at(3.2, 0, -3.2))
            made += place(low, yaw, pitch, mg, at(0, 0, -5.5) if w == 'lods_side' else at(-3.2, 0, 3.2))
        elif w == 'low_close':
            made += place(low, yaw, pitch, mg)
        else:
            made += place(high, yaw, pitch, mg)
        e, t = ZUP @ Vector(eye), ZUP @ Vector(target)
        camera.location = e
        camera.rotation_euler = (t - e).to_track_quat('-Z', 'Y').to_euler()
        camera.data.lens = lens
        scene.render.filepath = '/tmp/tank_%s_%s.png' % (name, w)
        bpy.ops.render.render(write_still=True)
        shots.append(scene.render.filepath)
        for o in made:
            bpy.data.objects.remove(o)
    cols = 2 if big else 4
    cw, ch = scene.render.resolution_x, scene.render.resolution_y
    sheet = Image.new('RGB', (cols * cw, -(-len(shots) // cols) * ch))
    for i, s in enumerate(shots):
        sheet.paste(Image.open(s).convert('RGB'), (i % cols * cw, i // cols * ch))
    sheet.save('/tmp/tank_%s.png' % name)


main(sys.argv[sys.argv.index('--') + 1 :])
