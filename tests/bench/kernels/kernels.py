#!/usr/bin/env python3
"""What accuracy costs: writes the table in docs/performance.md.

    cmake --preset release -DBUILD_TESTING=ON && cmake --build build/release --target bench_kernels
    tests/bench/kernels/kernels.py [--times] [BENCH_KERNELS]

Times come from interleaved runs of one process; instructions from valgrind --tool=callgrind, as the
difference of a picture of 96 x 72 pixels and one of 8 x 6, so that loading and compiling drop out.
With --times they are left out.
"""
import json
import os
import re
import subprocess
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "tests", "bench"))
import page_part  # noqa: E402

PAGE = os.path.join(ROOT, "docs", "performance.md")

# The replaced methods, the set of kernels that replaces them, and a scene that shows the effect.
METHODS = [
    ("sphere", "shapes", "spheres"),
    ("box", "shapes", "boxes"),
    ("plane", "shapes", "planes"),
    ("triangle", "shapes", "triangles"),
    ("cylinder and cone", "shapes", "frusta"),
    ("slab tests of the tree", "tree", "triangles"),
    ("starts as sums of two numbers, mapped starts", "places", "harbour"),
    ("contacts, rule for bodies of glass", "contacts", "glass"),
]
SCENES = ["spheres", "boxes", "planes", "triangles", "frusta", "harbour", "glass"]


def instructions(bench, kernels, scene):
    def run(width):
        out = subprocess.run(
            ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", bench, kernels, scene, str(width)],
            capture_output=True, text=True, check=True)
        return int(re.search(r"refs:\s*([\d,]+)", out.stderr).group(1).replace(",", ""))
    return run(96) - run(8)


def row(bench, times, count, what, kernels, scene):
    counted = " | | "
    if count:
        own, other = instructions(bench, "own", scene), instructions(bench, kernels, scene)
        counted = f"{own / 1e6:.1f} | {other / 1e6:.1f} | {own / other:.2f}"
    measured = times[scene][kernels]
    return (f"| {what} | {scene} | {measured['ratio']:.2f} | {100 * measured['different']:.2f} % | {counted} |\n")


def main():
    named = [a for a in sys.argv[1:] if a != "--times"]
    count = "--times" not in sys.argv
    bench = os.path.abspath(named[0] if named else os.path.join(ROOT, "build/release/bin/bench_kernels"))
    times = json.loads(subprocess.run([bench], capture_output=True, text=True, check=True).stdout)
    head = ("| {} | scene | time ratio | pixels that differ | million instructions | with textbook's | ratio |\n"
            "|---|---|---|---|---|---|---|\n")
    table = head.format("method") + "".join(row(bench, times, count, *method) for method in METHODS)
    table += "\n" + head.format("all together")
    table += "".join(row(bench, times, count, "all", "all", scene) for scene in SCENES)
    page_part.write(PAGE, "tests/bench/kernels/kernels.py", table)


if __name__ == "__main__":
    main()
