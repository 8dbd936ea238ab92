"""A stranger's ray tracer: spheres, planes and boxes, point lights, shadows and mirrors, from a reference pack.
stranger.py FOLDER OUT.png renders FOLDER/scene.json and compares it with the pack."""
import json
import math
import struct
import sys
import zlib


def add(a, b): return [x + y for x, y in zip(a, b)]
def sub(a, b): return [x - y for x, y in zip(a, b)]
def times(a, k): return [x * k for x in a]
def mul(a, b): return [x * y for x, y in zip(a, b)]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def unit(a): return times(a, 1 / math.sqrt(dot(a, a)))
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def hits(shape, o, d):
    """Distance and normal of each crossing of the ray o + t d with the surface."""
    if shape["kind"] == "sphere":
        c = sub(o, shape["center"])
        b, q = dot(c, d), dot(c, c) - shape["radius"] ** 2
        if b * b - q > 0:
            for root in (-math.sqrt(b * b - q), math.sqrt(b * b - q)):
                yield root - b, unit(sub(add(o, times(d, root - b)), shape["center"]))
    elif shape["kind"] == "plane":
        n = unit(shape["normal"])
        if dot(n, d) != 0:
            yield (shape["offset"] - dot(n, o)) / dot(n, d), n
    elif shape["kind"] == "box":
        for axis in range(3):
            for side in ("min", "max"):
                if d[axis] == 0:
                    continue
                t = (shape[side][axis] - o[axis]) / d[axis]
                p = add(o, times(d, t))
                if all(shape["min"][k] <= p[k] <= shape["max"][k] for k in range(3) if k != axis):
                    yield t, [(1 if side == "max" else -1) * (k == axis) for k in range(3)]
    else:
        raise SystemExit(f"this ray tracer has no {shape['kind']}")


def nearest(scene, o, d, least, most=math.inf, shadow=False):
    found = None
    for index, thing in enumerate(scene["objects"]):
        if not shadow or thing["casts_shadow"]:
            for t, n in hits(thing, o, d):
                if least < t < most:
                    most, found = t, (t, n, index)
    return found


def color_at(scene, material, p):
    if material["texture"] is None:
        return material["color"]
    pattern = scene["textures"][material["texture"]]
    return pattern["odd" if sum(math.floor(x) for x in p) % 2 else "even"]


def trace(scene, o, d, depth, least=0.0):
    hit = nearest(scene, o, d, least)
    if hit is None:
        return scene["background"], None
    t, n, index = hit
    p, n = add(o, times(d, t)), n if dot(n, d) <= 0 else times(n, -1)
    m = scene["materials"][scene["objects"][index]["material"]]
    c = color_at(scene, m, p)
    light = mul(c, add(times(scene["ambient"], m["ambient"]), m["emission"]))
    mirrored = sub(d, times(n, 2 * dot(d, n)))
    for lamp in scene["lights"]:
        way = sub(lamp["position"], p)
        distance, to = math.sqrt(dot(way, way)), unit(way)
        if dot(n, to) > 0 and not nearest(scene, p, to, 1e-9, distance, shadow=True):
            strength = lamp["color"]
            if lamp["fade"]:
                strength = times(strength, 2 / (1 + (distance / lamp["fade"]["distance"]) ** lamp["fade"]["power"]))
            light = add(light, times(mul(c, strength), m["diffuse"] * dot(n, to)))
            light = add(light, times(strength, m["phong"] * max(0, dot(mirrored, to)) ** m["shininess"]))
    if any(m["reflection"]) and depth > 1:
        light = add(light, mul(m["reflection"], trace(scene, p, mirrored, depth - 1, 1e-9)[0]))
    return light, hit


def camera_ray(scene, i, j):
    camera, w, h = scene["camera"], scene["width"], scene["height"]
    z = unit(sub(camera["position"], camera["look_at"]))
    x = unit(cross(camera["up"], z))
    u, v = (2 * (i + 0.5) / w - 1) * w / h, 1 - 2 * (j + 0.5) / h
    aside = add(times(x, u), times(cross(z, x), v))
    return camera["position"], unit(sub(times(aside, math.tan(math.radians(camera["fov"] / 2))), z))


def write_png(path, w, h, rows):
    """16 bits; gAMA 1 says that the numbers are light."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    lines = b"".join(b"\0" + struct.pack(f">{3 * w}H", *(round(65535 * min(1, max(0, v))) for v in row)) for row in rows)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", w, h, 16, 2, 0, 0, 0))
                   + chunk(b"gAMA", struct.pack(">I", 100000)) + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


def main(folder, out):
    with open(f"{folder}/scene.json") as file:
        scene = json.load(file)
    w, h, depth = scene["width"], scene["height"], scene["max_depth"]
    picture = [[trace(scene, *camera_ray(scene, i, j), depth)[0] for i in range(w)] for j in range(h)]
    write_png(out, w, h, [[v for pixel in row for v in pixel] for row in picture])
    worst = 0
    for probe in scene["probes"]:
        light, hit = trace(scene, *camera_ray(scene, probe["x"], probe["y"]), depth)
        assert (hit and hit[2]) == probe["object"], f"another object at {probe['x']}, {probe['y']}"
        off = max(abs(a - b) for a, b in zip(light, probe["color"]))
        assert off <= 1e-9 + max(probe["color_error"]), f"{light} at {probe['x']}, {probe['y']}: {probe['color']}"
        worst = max(worst, off)
    print(f"{len(scene['probes'])} probes agree, the worst is off by {worst:.1e}")


if __name__ == "__main__":
    main(*sys.argv[1:])
