#!/usr/bin/env python3
"""Measures what the project has promised about whole runs, and prints it beside the promise.

    tests/bench/targets.py [LANCER]        default: build/release/bin/lancer

Each row is the median of five runs. The inputs are made in a temporary folder.
"""
import json
import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

RUNS = 5


def run(command, folder):
    """Seconds of processor time, wall-clock seconds and peak bytes of one run."""
    start = time.perf_counter()
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.perf_counter() - start
    if os.waitstatus_to_exitcode(status) != 0:
        raise SystemExit(f"failed: {' '.join(command)}")
    return usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss * 1024


def medians(command, folder, stats=None):
    """Medians over RUNS; with `stats`, the phases of that file as well."""
    rows, phases = [], []
    run(command, folder)
    for _ in range(RUNS):
        rows.append(run(command, folder))
        if stats:
            with open(os.path.join(folder, stats)) as file:
                phases.append(json.load(file)["seconds"])
    cpu, wall, peak = (statistics.median(column) for column in zip(*rows))
    phase = {k: statistics.median(p[k] for p in phases) for k in phases[0]} if phases else {}
    return cpu, wall, peak, phase


def write(folder, name, text):
    with open(os.path.join(folder, name), "w") as file:
        file.write(text)


CAMERA = "camera main { position [0, 0, 9] look_at [0, 0, 0] }\nlight point { position [5, 5, 9] }\n"


def make_inputs(folder):
    spheres = []
    for i in range(66000):
        x, y, z = (math.sin(i * 1.3) * 3, math.cos(i * 0.7) * 3, math.sin(i * 0.31) * 3)
        spheres.append(f"sphere {{ center [{x:.12f}, {y:.12f}, {z:.12f}] radius 0.{i % 9 + 1}1 }}\n")
    write(folder, "flat.lancer", CAMERA + "".join(spheres))
    write(folder, "loop.lancer", CAMERA +
          "def ball(i) { sphere { center [i % 300, floor(i / 300), 0] / 100 radius 0.004 } }\n"
          "for i in 0..100000 { ball(i) }\n")
    write(folder, "one.lancer", "image { width 64 height 64 }\n" + CAMERA + "sphere { radius 2 }\n")
    n = 708  # 708 x 708 squares: 1,002,528 triangles
    with open(os.path.join(folder, "big.obj"), "w") as file:
        for j in range(n + 1):
            for i in range(n + 1):
                x, z = i / n * 4 - 2, j / n * 4 - 2
                file.write(f"v {x:.15f} {0.3 * math.sin(3 * x) * math.cos(4 * z):.15f} {z:.15f}\n")
        for j in range(n):
            for i in range(n):
                a = j * (n + 1) + i + 1
                file.write(f"f {a} {a + n + 1} {a + 1}\nf {a + 1} {a + n + 1} {a + n + 2}\n")
    write(folder, "mesh.lancer", "image { width 64 height 48 }\n" + CAMERA + 'mesh { file "big.obj" rotate_x 30 }\n')


def main():
    lancer = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/release/bin/lancer")
    folder = tempfile.mkdtemp(prefix="lancer-bench-")
    try:
        make_inputs(folder)
        size = os.path.getsize(os.path.join(folder, "flat.lancer")) / 1e6
        base = [lancer, "render", "--quiet", "--stats", "stats.json", "-o", "out.png"]
        print(f"{'what':<58}{'measured':>12}{'promised':>12}")

        def row(what, value, promised, unit="s"):
            print(f"{what:<58}{value:>10.3f} {unit}{promised:>10} {unit}")

        cpu, _, _, _ = medians([lancer, "check", "flat.lancer"], folder)
        row(f"check of 66,000 spheres ({size:.1f} MB): processor time", cpu, "0.15")
        cpu, _, _, _ = medians([lancer, "check", "loop.lancer"], folder)
        row("check of 100,000 iterations with a call: processor time", cpu, "0.2")
        _, _, peak, phase = medians(base + ["mesh.lancer"], folder, "stats.json")
        ready = phase["parse"] + phase["evaluate"] + phase["build"]
        size = os.path.getsize(os.path.join(folder, "big.obj")) / 1e6
        row(f"1,002,528 triangles from {size:.0f} MB OBJ: ready to trace", ready, "3")
        row("  the same: peak memory", peak / 1e6, "500", "MB")
        _, wall, _, phase = medians(base + ["one.lancer"], folder, "stats.json")
        row("64 x 64 picture of a sphere: whole process", wall, "0.06")
        print("  its phases: " + ", ".join(f"{k} {v:.4f}" for k, v in phase.items()))
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()
