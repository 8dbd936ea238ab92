"""Adaptive samples against a full grid of 4 x 4: rays for the same error. The runs of bench_adaptive as a table and a plot."""
import csv
import subprocess

import measured
import plots

THIN = ["wires", "horizon", "highlights"]  # beside this file
# Glass with deep rays takes minutes at the larger size.
SLOW = ["globe", "chess"]
SIZES = {(128, 96): [*THIN, *measured.GALLERY], (640, 480): [*THIN, *(s for s in measured.GALLERY if s not in SLOW)]}
FULL = 16  # rays a pixel of the grid
MOST_SOBOL = 24  # that bench_adaptive tries


def path(scene):
    return measured.ROOT / ("tests/bench/study/scenes" if scene in THIN else "scenes/gallery") / f"{scene}.lancer"


def read(text):
    return {row.pop("scene"): {name: float(value) for name, value in row.items()} for row in csv.DictReader(text.splitlines())}


def cells(numbers):
    if numbers is None:
        return ["", "", "", ""]
    sobol = numbers["sobol"]
    return [f"{numbers['error']:.2g}", f"{sobol:.2g}" if sobol < MOST_SOBOL else f"above {MOST_SOBOL}", f"{numbers['adaptive']:.2g}", f"{100 * numbers['adaptive'] / FULL:.0f} %"]


def table(found):
    """`found`: {size: {scene: numbers}}"""
    names = [f"{w} x {h}" for w, h in found]
    means = [{k: measured.mean([n[k] for n in of.values()]) for k in ("error", "sobol", "adaptive")} for of in found.values()]
    scenes = list(next(iter(found.values())))
    rows = [(scene, [of.get(scene) for of in found.values()]) for scene in scenes] + [("mean", means)]
    head = ["scene", *(text for name in names for text in (f"{name}: RMSE", "Sobol", "adaptive", "of the grid's rays"))]
    text = measured.table(head, [[scene, *(c for numbers in row for c in cells(numbers))] for scene, row in rows])
    groups = {scene: [(name, 100 * n["adaptive"] / FULL) for name, n in zip(names, row) if n] for scene, row in rows}
    return text, {"study_adaptive.svg": plots.bars("Rays for the error of a full 4 x 4 grid", "% of its rays", groups)}


def study(lancer, rounds):
    del rounds  # rays are counted
    found = {}
    for size, scenes in SIZES.items():
        done = subprocess.run([lancer.program.parent / "bench_adaptive", *map(str, size), *map(path, scenes)], check=True, capture_output=True,
                              text=True)
        found[size] = read(done.stdout)
        print("{} x {}".format(*size), flush=True)
    return table(found)
