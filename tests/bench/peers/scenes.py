"""The fixed set of scenes. E. Haines, A proposal for standard graphics environments, IEEE CG&A 7(11), 1987."""
import math
import random

from stage import Mesh, Stage, triple

SKY = (0.078, 0.361, 0.753)
LIGHTS = ((4, 3, 2), (1, -4, 4), (-3, 1, 5))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def haines_stage(max_depth=5, lights=LIGHTS):
    stage = Stage(SKY, max_depth)
    stage.camera((2.1, 1.3, 1.7), (0, 0, 0), (0, 0, 1), 45)
    for position in lights:
        stage.light(position, [1 / math.sqrt(len(lights))] * 3)
    stage.material("ground", (1, 0.75, 0.33), 0.1, 0.8)
    stage.material("ball", (1, 0.9, 0.7), 0.1, 0.5, reflection=0.5, phong=0.3, shininess=12)
    stage.plane((0, 0, 1), -0.5, "ground")
    return stage


def flake(stage, depth, center=(0.0, 0.0, 0.0), radius=0.5, axis=(0.0, 0.0, 1.0), material="ball"):
    """A ball, and nine of a third of its size round it: six at its equator, three above."""
    stage.sphere(center, radius, material)
    if depth == 0:
        return
    side = unit(cross(axis, (1, 0, 0) if abs(axis[0]) < 0.9 else (0, 1, 0)))
    other = cross(axis, side)
    for count, tilt, turn in ((6, 90, 0), (3, 35.26438968, 30)):
        for i in range(count):
            a, b = math.radians(turn + 360 * i / count), math.radians(tilt)
            out = [math.sin(b) * (math.cos(a) * s + math.sin(a) * o) + math.cos(b) * n
                   for s, o, n in zip(side, other, axis)]
            flake(stage, depth - 1, tuple(c + 4 / 3 * radius * d for c, d in zip(center, out)), radius / 3, tuple(out),
                  material)


def balls(depth):
    def build(folder):
        stage = haines_stage()
        flake(stage, depth)
        return stage
    return build


def torus_knot(around, across):
    """A tube round the knot (2, 3): around x across x 2 triangles, with true normals of a circle swept along it."""
    def at(t):
        r = 2 + math.cos(3 * t)
        return (r * math.cos(2 * t) / 3, r * math.sin(2 * t) / 3, math.sin(3 * t) / 3)
    mesh = Mesh()
    for i in range(around):
        t = 2 * math.pi * i / around
        here, ahead, behind = at(t), at(t + 1e-4), at(t - 1e-4)
        along = unit([a - b for a, b in zip(ahead, behind)])
        side = unit(cross(along, here))
        up = cross(side, along)
        for k in range(across):
            a = 2 * math.pi * k / across
            normal = [math.cos(a) * s + math.sin(a) * u for s, u in zip(side, up)]
            mesh.points.append(tuple(h + 0.16 * n for h, n in zip(here, normal)))
            mesh.normals.append(tuple(normal))
            p, q = i * across, (i + 1) % around * across
            n = (k + 1) % across
            mesh.faces += [(p + k, q + k, q + n), (p + k, q + n, p + n)]
    return mesh


def knot(around, across):
    def build(folder):
        stage = haines_stage()
        stage.mesh(torus_knot(around, across), "ball", folder / "knot.obj")
        return stage
    return build


def glass(folder):
    """75 balls of glass in five layers, in rows of which each stands in the gaps of the other."""
    stage = haines_stage(max_depth=10)
    stage.lancer_alone("material glass { color [1, 1, 1] ambient 0 diffuse 0 transmission 0.9 reflection 0.1 "
                       "ior 1.5 phong 0.5 }")
    for layer in range(5):
        for x in range(5):
            for y in range(3):
                center = [(x - 2) * 0.3 + layer % 2 * 0.1, (y - 1) * 0.3, layer * 0.25 - 0.3]
                stage.lancer_alone(f"sphere {{ center {triple(center)} radius 0.11 material glass }}")
    return stage


def jars(folder):
    """15 jars: a cylinder of glass round one of coloured water, with a straw and a cube of ice in it."""
    stage = haines_stage(max_depth=10)
    clear = "color [1, 1, 1] ambient 0 diffuse 0 transmission 1 reflection 1 fresnel true"
    stage.lancer_alone(f"material glass {{ {clear} ior 1.5 phong 0.5 }}")
    stage.lancer_alone(f"material water {{ {clear} ior 1.33 absorption [2, 0.5, 0.2] }}")
    stage.lancer_alone(f"material ice {{ {clear} ior 1.31 }}")
    stage.lancer_alone("material straw { color [0.9, 0.2, 0.1] ambient 0.1 diffuse 0.7 phong 0.3 }")
    for i in range(15):
        x, y = (i % 5 - 2) * 0.4, (i // 5 - 1) * 0.4

        def cylinder(base, top, radius, material):
            stage.lancer_alone(f"cylinder {{ base {triple(base)} top {triple(top)} radius {radius} material {material} }}")
        cylinder([x, y, -0.49], [x, y, 0.15], 0.15, "glass")
        cylinder([x, y, -0.44], [x, y, 0.12], 0.14, "water")
        cylinder([x - 0.05, y, -0.4], [x + 0.05, y, 0.11], 0.012, "straw")
        ice = [x - 0.03, y + 0.03, 0.03]
        stage.lancer_alone(f"box {{ min {triple(ice)} max {triple([k + 0.07 for k in ice])} material ice }}")
    return stage


def glass_knot(folder):
    """A smooth mesh of glass that absorbs."""
    stage = haines_stage(max_depth=10)
    stage.lancer_alone("material glass { color [1, 1, 1] ambient 0 diffuse 0 transmission 0.9 reflection 0.1 "
                       "ior 1.5 phong 0.5 absorption [3, 0.5, 1] }")
    torus_knot(150, 24).write_obj(folder / "knot.obj")
    stage.lancer_alone('mesh { file "knot.obj" material glass }')
    return stage


def solid_text(draw, kind, size, material):
    place = [draw(-1, 1), draw(-1, 1), draw(-0.45, 0.8)]
    far = [p + size * draw(0.5, 1) for p in place]
    if kind == 0:
        return f"box {{ min {triple(place)} max {triple(far)} material {material} }}"
    if kind == 1:
        return f"cylinder {{ base {triple(place)} top {triple(far)} radius {size / 3:.6f} material {material} }}"
    if kind == 2:
        return f"cone {{ base {triple(place)} top {triple(far)} base_radius {size / 2:.6f} material {material} }}"
    return f"sphere {{ center {triple(place)} radius {size / 2:.6f} material {material} }}"


def mixed(folder, count=100_000):
    draw = random.Random(4).uniform
    stage = haines_stage()
    for i in range(count):
        stage.lancer_alone(solid_text(draw, i % 4, 0.012, "ball" if i % 16 < 4 else "ground"))
    return stage


def many_lights(folder):
    draw = random.Random(5).uniform
    stage = haines_stage(lights=[(draw(-4, 4), draw(-4, 4), draw(2, 5)) for _ in range(32)])
    flake(stage, 2)
    return stage


def textured(folder):
    """Checkers on the ground and gradients on 820 balls, one pattern for each size."""
    stage = haines_stage()
    stage.lancer_alone("""texture tiles { checker [[1, 1, 1], [0.1, 0.3, 0.1]] scale 0.2 translate [0, 0, 0.05] }
texture ramp { gradient [1, 2, 3] stops [[0, [1, 0.2, 0.1]], [0.5, [0.9, 0.9, 0.5]], [1, [1, 0.2, 0.1]]] scale 0.3 }
material floor { color tiles ambient 0.1 diffuse 0.8 }
material striped { color ramp ambient 0.1 diffuse 0.6 phong 0.3 }
plane { normal [0, 0, 1] offset -0.49 material floor }""")
    flake(stage, 3, material="striped")
    return stage


def rings(folder, count=400):
    """Tori of all widths, turned at random."""
    draw = random.Random(7).uniform
    stage = haines_stage()
    for _ in range(count):
        radius = draw(0.04, 0.12)
        place = [draw(-1, 1), draw(-1, 1), draw(-0.4, 0.8)]
        stage.lancer_alone(f"torus {{ radius {radius:.6f} tube {radius * draw(0.1, 0.6):.6f} material ball "
                           f"rotate [{triple([draw(-1, 1), draw(-1, 1), 1])}, {draw(0, 360):.3f}] "
                           f"translate {triple(place)} }}")
    return stage


def instances(folder, count=100_000):
    """One mesh of 1,000 triangles, shown a hundred thousand times, turned and sized at random."""
    draw = random.Random(6).uniform
    torus_knot(50, 10).write_obj(folder / "knot.obj")
    stage = haines_stage()
    for _ in range(count):
        place = [draw(-1.2, 1.2), draw(-1.2, 1.2), draw(-0.45, 0.9)]
        stage.lancer_alone(f'mesh {{ file "knot.obj" material ball scale {draw(0.005, 0.015):.6f} '
                           f"rotate [{triple([draw(-1, 1), draw(-1, 1), 1])}, {draw(0, 360):.3f}] "
                           f"translate {triple(place)} }}")
    return stage


# The name in the table, the function that builds it (or a scene of the gallery), the picture's
# side, samples per axis.
ALL = [
    ("sphereflake, 91 balls", balls(2), 2048, 1),
    ("sphereflake, 820 balls", balls(3), 2048, 1),
    ("sphereflake, 7,381 balls", balls(4), 1024, 1),
    ("sphereflake, 66,430 balls", balls(5), 1024, 1),
    ("sphereflake, 597,871 balls", balls(6), 1024, 1),
    ("torus knot, 50,000 smooth triangles", knot(500, 50), 1024, 1),
    ("torus knot, 1,000,000 smooth triangles", knot(2500, 200), 1024, 1),
    ("75 balls of glass, depth 10", glass, 1024, 1),
    ("15 jars of coloured water, depth 10", jars, 1024, 1),
    ("torus knot of glass, 7,200 smooth triangles", glass_knot, 1024, 1),
    ("100,000 boxes, cylinders, cones and balls", mixed, 1024, 1),
    ("400 rings", rings, 1024, 1),
    ("91 balls, 32 lights", many_lights, 1024, 1),
    ("820 balls, checkers and gradients", textured, 1024, 1),
    ("100,000 instances of a mesh", instances, 1024, 1),
    ("`gallery/teapot`", "teapot", 1024, 1),
    ("`gallery/harbour`, 3 x 3 samples", "harbour", 512, 3),
    ("`gallery/orrery`, 3 x 3 samples", "orrery", 512, 3),
    ("`gallery/mirror_hall`, 3 x 3 samples", "mirror_hall", 512, 3),
]
