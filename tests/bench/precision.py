#!/usr/bin/env python3
"""Single precision beside double: writes the table in docs/performance.md.

    tests/bench/precision.py [LANCER]      default: build/release/bin/lancer

Times of tracing alone, one thread, the two in turn; 320 x 240 pixels of 2 x 2 rays. Four minutes; a third of a GB.
"""
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile

import page_part

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
PAGE = os.path.join(ROOT, "docs", "performance.md")
ROUNDS = 9
GALLERY = ["harbour", "globe", "orrery", "chess", "teapot", "knot"]
STAGE = """render { max_depth 4 }
camera main { position [0, 9, 22] look_at [0, 0, 0] fov 50 }
light point { position [12, 18, 25] }
material m { color [0.8, 0.5, 0.3] ambient 0.2 reflection REFLECTION }
mesh { file "mesh.obj" material m smooth false }
"""


def loose_triangles(file, count=1_000_000):
    """A cloud of small triangles that hide little of each other, like leaves."""
    draw = random.Random(2).uniform
    for _ in range(count):
        x, y, z = (draw(-10, 10) for _ in range(3))
        for _ in range(3):
            file.write(f"v {x + draw(-0.03, 0.03):.6f} {y + draw(-0.03, 0.03):.6f} {z + draw(-0.03, 0.03):.6f}\n")
    for i in range(1, 3 * count, 3):
        file.write(f"f {i} {i + 1} {i + 2}\n")


def rough_ground(file, side=700):
    """One sheet of 2 side^2 triangles, each tilted its own way."""
    draw = random.Random(1).random
    for z in range(side + 1):
        for x in range(side + 1):
            file.write(f"v {x / side * 20 - 10:.6f} {draw() * 0.05:.6f} {z / side * 20 - 10:.6f}\n")
    for z in range(side):
        for x in range(side):
            a = z * (side + 1) + x + 1
            b = a + side + 1
            file.write(f"f {a} {b} {b + 1}\nf {a} {b + 1} {a + 1}\n")


def written(folder, name, mesh, reflection):
    os.mkdir(os.path.join(folder, name))
    with open(os.path.join(folder, name, "mesh.obj"), "w") as file:
        mesh(file)
    scene = os.path.join(folder, name, "scene.lancer")
    with open(scene, "w") as file:
        file.write(STAGE.replace("REFLECTION", str(reflection)))
    return scene


def traced(lancer, scene, precision, folder):
    """Seconds of tracing, and the peak of memory in MB."""
    stats = os.path.join(folder, "stats.json")
    subprocess.run([lancer, "render", scene, "--threads", "1", "--size", "320x240", "--samples", "2", "--precision",
                    precision, "-q", "--stats", stats, "-o", os.path.join(folder, "out.png")], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(stats) as file:
        measured = json.load(file)
    return measured["seconds"]["trace"], measured["peak_memory_bytes"] / 1e6


def row(lancer, name, scene, folder):
    ratios, seconds, memory = [], [], {}
    for _ in range(ROUNDS):
        double, memory["double"] = traced(lancer, scene, "double", folder)
        single, memory["single"] = traced(lancer, scene, "single", folder)
        ratios.append(double / single)
        seconds.append(double)
    # For a small scene, the peak is that of the process that started the run.
    peaks = [f"{memory[p]:.0f} MB" if memory[p] > 100 else "" for p in ("double", "single")]
    return (f"| {name} | {statistics.median(seconds):.2f} s | {statistics.median(ratios):.2f} "
            f"| {peaks[0]} | {peaks[1]} |\n")


def main():
    lancer = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build/release/bin/lancer"))
    table = ("| scene | double | times as fast in single | memory, double | memory, single |\n"
             "|---|---|---|---|---|\n")
    with tempfile.TemporaryDirectory() as folder:
        for name in GALLERY:
            table += row(lancer, f"`gallery/{name}`", os.path.join(ROOT, "scenes", "gallery", name + ".lancer"), folder)
        for name, mesh, reflection in (("a million loose triangles", loose_triangles, 0),
                                       ("rough ground of a million triangles, a mirror", rough_ground, 0.6)):
            table += row(lancer, name, written(folder, name, mesh, reflection), folder)
    page_part.write(PAGE, "tests/bench/precision.py", table)


if __name__ == "__main__":
    main()
