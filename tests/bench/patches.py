#!/usr/bin/env python3
"""Measures patches on their true surface and as triangles for tolerances 1e-1 to 1e-6, and writes table and plot
into docs/accuracy.md (between its marks) and docs/pictures/patch_tolerance.svg.

    tests/bench/patches.py [BENCH_PATCHES [FINEST]]

Without a program build/release/bin/bench_patches is built. FINEST: the smallest tolerance, 1e-6. Some minutes; at 1e-6
the teapot takes fifty million triangles and 6 GB.
"""
import math
import os
import subprocess
import sys

import page_part

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAGE = os.path.join(ROOT, "docs", "accuracy.md")
PLOT = os.path.join(ROOT, "docs", "pictures", "patch_tolerance.svg")
NAMES = {"teapot": "teapot", "random": "16 bent patches"}
COLORS = {"teapot": "#1f6fb4", "random": "#c8501e"}


def built():
    subprocess.run(["cmake", "--preset", "release", "-DBUILD_TESTING=ON"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", "build/release", "--target", "bench_patches"], cwd=ROOT, check=True,
                   stdout=subprocess.DEVNULL)
    return os.path.join(ROOT, "build", "release", "bin", "bench_patches")


def measured(program, finest):
    scene = os.path.join(ROOT, "scenes", "gallery", "teapot.lancer")
    text = subprocess.run([program, scene, finest], check=True, capture_output=True, text=True).stdout
    cases, crowd = [], []
    for line in text.splitlines():
        kind, *values = line.split("\t")
        if kind == "case":
            scene, *numbers = values
            keys = ("tolerance", "triangles", "memory", "build", "trace", "rmse")
            cases.append({"scene": scene, **dict(zip(keys, map(float, numbers)))})
        elif kind == "crowd":
            crowd.append(values)
    return cases, crowd


def power(value):
    return f"1e{round(math.log10(value))}"


def left_out(case):
    """The row of the next finer tolerance, which the run was told to leave out."""
    return (f"| {NAMES[case['scene']]} | {power(case['tolerance'] / 10)} | not run: about "
            f"{10 * case['triangles'] / 1e6:.0f} million | about {10 * case['memory'] / 1e3:.0f} GB | – | – | – |")


def table(cases, crowd):
    lines = ["| Scene | tolerance | triangles | memory | build | trace | RMSE |", "|---|---|---|---|---|---|---|"]
    for c in cases:
        asked = power(c["tolerance"]) if c["tolerance"] else "none: true surface"
        triangles = f"{c['triangles']:,.0f}" if c["tolerance"] else "–"
        lines.append(f"| {NAMES[c['scene']]} | {asked} | {triangles} | {c['memory']:.1f} MB | {c['build']:.2f} s "
                     f"| {c['trace']:.2f} s | {c['rmse']:.1e} |")
        is_finest = c["tolerance"] and c["tolerance"] == min(o["tolerance"] for o in cases if o["tolerance"])
        if is_finest and c["tolerance"] > 1.1e-6:
            lines.append(left_out(c))
    lines += ["", "![The picture's error against the tolerance, and against the time](pictures/patch_tolerance.svg)",
              "", "| 10,000 patches, 100 in sight | work | time | memory |", "|---|---|---|---|"]
    for name, work, seconds, memory in crowd:
        what = "picture, cut on demand" if work == "on demand" else "cutting all of them, no picture"
        lines.append(f"| {name} | {what} | {seconds} s | {memory} MB |")
    return "\n".join(lines)


class Panel:
    """A plot with two logarithmic axes."""

    def __init__(self, left, title, across, x_range, y_range):
        self.left, self.x_range, self.y_range = left, x_range, y_range
        self.parts = [f'<text x="{left + 150}" y="20" text-anchor="middle" font-weight="bold">{title}</text>',
                      f'<text x="{left + 150}" y="318" text-anchor="middle">{across}</text>',
                      f'<rect x="{left}" y="30" width="300" height="250" fill="none" stroke="#888"/>']
        for k in range(x_range[0], x_range[1] + 1):
            x = self.x(10.0 ** k)
            self.parts.append(f'<path d="M{x:.1f} 30v250" stroke="#ddd"/>'
                              f'<text x="{x:.1f}" y="297" text-anchor="middle">1e{k}</text>')
        for k in range(y_range[0], y_range[1] + 1):
            y = self.y(10.0 ** k)
            self.parts.append(f'<path d="M{left} {y:.1f}h300" stroke="#ddd"/>'
                              f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">1e{k}</text>')

    def x(self, value):
        low, high = self.x_range
        return self.left + 300 * (math.log10(value) - low) / (high - low)

    def y(self, value):
        low, high = self.y_range
        return 280 - 250 * (math.log10(value) - low) / (high - low)

    def line(self, points, color):
        path = " ".join(f"{self.x(x):.1f},{self.y(y):.1f}" for x, y in points)
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="2"/>')
        self.parts += [f'<circle cx="{self.x(x):.1f}" cy="{self.y(y):.1f}" r="3" fill="{color}"/>' for x, y in points]

    def upright(self, value, color):
        self.parts.append(f'<path d="M{self.x(value):.1f} 30v250" stroke="{color}" stroke-width="2" '
                          'stroke-dasharray="5 4"/>')


def plot(cases):
    def exponents(values):
        return math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))

    finite = [c for c in cases if c["tolerance"]]
    seconds = [c["build"] + c["trace"] for c in cases]
    errors = exponents([c["rmse"] for c in finite])
    by_tolerance = Panel(60, "RMSE against tolerance", "tolerance", exponents([c["tolerance"] for c in finite]), errors)
    by_time = Panel(430, "RMSE against time", "seconds, build and trace; dashed: the true surface", exponents(seconds),
                    errors)
    legend = []
    for i, (scene, color) in enumerate(COLORS.items()):
        own = [c for c in finite if c["scene"] == scene]
        by_tolerance.line([(c["tolerance"], c["rmse"]) for c in own], color)
        by_time.line([(c["build"] + c["trace"], c["rmse"]) for c in own], color)
        for c in cases:
            if c["scene"] == scene and not c["tolerance"]:
                by_time.upright(c["build"] + c["trace"], color)
        legend.append(f'<text x="{80 + 130 * i}" y="46" fill="{color}">{NAMES[scene]}</text>')
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="760" height="330" font-family="sans-serif" font-size="12">',
             '<rect width="760" height="330" fill="white"/>', *by_tolerance.parts, *by_time.parts, *legend, "</svg>"]
    with open(PLOT, "w") as file:
        file.write("\n".join(parts) + "\n")


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else built()
    cases, crowd = measured(program, sys.argv[2] if len(sys.argv) > 2 else "1e-6")
    plot(cases)
    page_part.write(PAGE, "tests/bench/patches.py", table(cases, crowd) + "\n")


if __name__ == "__main__":
    main()
