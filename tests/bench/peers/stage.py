"""A scene said twice: in Lancer's language, from which POV-Ray's file is exported, and in Tachyon's."""
import math


def triple(v):
    return "[" + ", ".join(f"{x:.17g}" for x in v) + "]"


def plain(v):
    return " ".join(f"{x:.17g}" for x in v)


def mirrored(v):
    """Tachyon's space is left-handed: its scene is the mirror image."""
    return plain((-v[0], v[1], v[2]))


class Stage:
    """Collects both texts. `can_tachyon` says whether Tachyon has words for the scene."""

    def __init__(self, background, max_depth):
        self.lancer = [f"render {{ max_depth {max_depth} }}", f"background {triple(background)}"]
        self.background, self.max_depth = background, max_depth
        self.tachyon = []
        self.can_tachyon = True
        self.view = None

    def camera(self, position, look_at, up, fov):
        self.lancer.append(f"camera main {{ position {triple(position)} look_at {triple(look_at)} up {triple(up)} "
                           f"fov {fov} }}")
        self.view = position, look_at, up, fov

    def light(self, position, color):
        self.lancer.append(f"light point {{ position {triple(position)} color {triple(color)} }}")
        self.tachyon.append(f"LIGHT CENTER {mirrored(position)} RAD 1e-9 COLOR {plain(color)}")

    def material(self, name, color, ambient, diffuse, reflection=0.0, phong=0.0, shininess=40):
        self.lancer.append(f"material {name} {{ color {triple(color)} ambient {ambient} diffuse {diffuse} "
                           f"reflection {reflection} phong {phong} shininess {shininess} }}")
        self.tachyon.append(f"TEXDEF {name} AMBIENT {ambient} DIFFUSE {diffuse} SPECULAR {reflection} OPACITY 1 "
                            f"PHONG PLASTIC {phong} PHONG_SIZE {shininess} COLOR {plain(color)} TEXFUNC 0")

    def sphere(self, center, radius, material):
        self.lancer.append(f"sphere {{ center {triple(center)} radius {radius:.17g} material {material} }}")
        self.tachyon.append(f"SPHERE CENTER {mirrored(center)} RAD {radius:.17g} {material}")

    def plane(self, normal, offset, material):
        self.lancer.append(f"plane {{ normal {triple(normal)} offset {offset} material {material} }}")
        self.tachyon.append(f"PLANE CENTER {mirrored([n * offset for n in normal])} NORMAL {mirrored(normal)} {material}")

    def mesh(self, mesh, material, file):
        """A mesh with a normal at each vertex: Lancer reads it from the file, Tachyon from its scene."""
        mesh.write_obj(file)
        self.lancer.append(f'mesh {{ file "{file.name}" material {material} }}')
        for face in (face[::-1] for face in mesh.faces):  # mirrored
            words = [f"V{i} {mirrored(mesh.points[k])}" for i, k in enumerate(face)]
            words += [f"N{i} {mirrored(mesh.normals[k])}" for i, k in enumerate(face)]
            self.tachyon.append(f"STRI {' '.join(words)} {material}")

    def lancer_alone(self, text):
        self.lancer.append(text)
        self.can_tachyon = False

    def write(self, folder, width, height):
        """Writes scene.lancer and, where it can be said, scene.dat."""
        (folder / "scene.lancer").write_text("\n".join(self.lancer) + "\n")
        if not self.can_tachyon:
            return
        position, look_at, up, fov = self.view
        forward = [a - b for a, b in zip(look_at, position)]
        length = math.sqrt(sum(x * x for x in forward))
        head = ["BEGIN_SCENE", f"RESOLUTION {width} {height}",
                f"CAMERA PROJECTION PERSPECTIVE ZOOM {0.5 / math.tan(math.radians(fov / 2)):.17g} ASPECTRATIO 1 "
                f"ANTIALIASING 0 RAYDEPTH {self.max_depth} CENTER {mirrored(position)} "
                f"VIEWDIR {mirrored([x / length for x in forward])} UPDIR {mirrored(up)} END_CAMERA",
                f"BACKGROUND {plain(self.background)}"]
        (folder / "scene.dat").write_text("\n".join(head + self.tachyon + ["END_SCENE"]) + "\n")


class Mesh:
    """Points, a normal for each, and triangles of indices."""

    def __init__(self):
        self.points, self.normals, self.faces = [], [], []

    def write_obj(self, file):
        with open(file, "w") as out:
            out.writelines(f"v {plain(p)}\n" for p in self.points)
            out.writelines(f"vn {plain(n)}\n" for n in self.normals)
            out.writelines("f " + " ".join(f"{k + 1}//{k + 1}" for k in face) + "\n" for face in self.faces)
