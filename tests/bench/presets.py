#!/usr/bin/env python3
"""Derives the presets of --quality from the gallery, and measures them: writes its parts of docs/cost-of-accuracy.md.

    tests/bench/presets.py [--derive | --measure] [--print] [--lancer build/release/bin/lancer]

To derive them takes bench_settings beside the program (-DBUILD_TESTING=ON) and ten minutes. It counts rays, so it finds
the same on every machine: of the Sobol points, or the grid, the fewest rays that reach what a preset aims at; then of the
limits the cheapest that add no more to the squared error than --max-error lets them.
"""
import argparse
import csv
import json
import math
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(__file__))
import page_part

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAGE = os.path.join(ROOT, "docs", "cost-of-accuracy.md")
SCENES = ["mirror_hall", "knot", "teapot", "harbour", "globe", "gears", "chess", "orrery"]
SIZE = "96x72"
EXACT = ("--quality", "exact")
# The purpose of each preset, as an RMSE.
AIMS = {"draft": (10 / 255, "10 steps of 8 bits"), "normal": (2.5 / 255, "2.5 steps"), "fine": (1 / 255, "1 step")}
# Depths are powers of two, among those that bench_settings tries. The cut is relative to the finest
# of them.
DEPTHS = [4, 8, 16, 32, 64]
# As a share of the squared error, in every scene: the same as for the limits of --max-error.
CUT_SHARE = 0.1


def path_of(scene):
    return os.path.join(ROOT, "scenes", "gallery", scene + ".lancer")


def mean(values):
    """The geometric one."""
    values = list(values)
    return math.exp(sum(math.log(v) for v in values) / len(values))


def swept(bench):
    """{(sampling, samples): {(depth, contribution): {scene: (RMSE, share of the rays of exact)}}}"""
    done = subprocess.run([bench, *SIZE.split("x"), "all", *map(path_of, SCENES)], check=True, capture_output=True, text=True)
    return read(done.stdout)


def read(text):
    found = {}
    for row in csv.DictReader(text.splitlines()):
        of_samples = found.setdefault((row["sampling"], int(row["samples"])), {})
        limits = int(row["depth"]), float(row["contribution"])
        of_samples.setdefault(limits, {})[row["scene"]] = float(row["error"]), float(row["cost"])
    return found


def summary(of_limits):
    """Means over the scenes: RMSE, and rays as a share of those of exact."""
    return mean(e for e, _ in of_limits.values()), mean(c for _, c in of_limits.values())


def derived(found, aim, coarser):
    """(sampling, samples), limits and how much these add to the squared error where they add most. `coarser`: limits that cut more."""
    uncut = max(next(iter(found.values())))[0], min(c for _, c in next(iter(found.values())))
    enough = [s for s, limits in found.items() if summary(limits[uncut])[0] <= aim]
    samples = min(enough, key=lambda s: summary(found[s][uncut])[1])
    whole = found[samples][uncut]

    def added(limits):
        return max((error / whole[scene][0]) ** 2 - 1 for scene, (error, _) in found[samples][limits].items())

    allowed = [limits for limits in found[samples] if limits[0] in DEPTHS and added(limits) <= CUT_SHARE and limits[0] > coarser[0] and limits[1] < coarser[1]]
    best = min(allowed, key=lambda limits: summary(found[samples][limits])[1])
    return samples, best, added(best)


def derived_table(found):
    lines = ["| preset | aim: RMSE | sampling | samples | depth | contribution | RMSE | limits add | rays, of those of exact |",
             "|---|---:|---|---:|---:|---:|---:|---:|---:|"]
    limits = 0, 1
    for name, (aim, text) in AIMS.items():
        (sampling, samples), limits, added = derived(found, aim, limits)
        error, cost = summary(found[sampling, samples][limits])
        lines.append(f"| `{name}` | {text} | {sampling} | {samples} x {samples} | {limits[0]} | {limits[1]:g} | {error:.2g} | {100 * added:.1f} % | "
                     f"1/{1 / cost:.3g} |")
    return "\n".join(lines) + "\n"


def render(lancer, scene, output, options):
    """Seconds of tracing, in one thread."""
    stats = output + ".json"
    subprocess.run([lancer, "render", path_of(scene), "--quiet", "--size", SIZE, "--threads", "1", "-o", output, "--stats", stats, *options],
                   check=True, stdout=subprocess.DEVNULL)
    with open(stats) as file:
        return json.load(file)["seconds"]["trace"]


def error_of(lancer, picture, truth):
    found = subprocess.run([lancer, "compare", picture, truth, "--json", "-"], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, check=False)
    return json.loads(found.stdout)["rmse"]


def measured_table(lancer):
    """Errors and times of the presets as they are, by the program."""
    settings = [("--quality", name) for name in [*AIMS, "exact"]]
    rows = {setting: [] for setting in settings}
    with tempfile.TemporaryDirectory(prefix="lancer-bench-") as folder:
        picture, truth = os.path.join(folder, "picture.exr"), os.path.join(folder, "truth.exr")
        for scene in SCENES:
            render(lancer, scene, truth, ["--samples", "16", "--sampling", "sobol", "--seed", "7", "--max-depth", "1000",
                                          "--min-contribution", "1e-12"])
            for setting in settings:
                seconds = render(lancer, scene, picture, setting)
                rows[setting].append((error_of(lancer, picture, truth), seconds))
            print(scene, file=sys.stderr)
    lines = ["| scene | " + " | ".join(f"{s[1]}: RMSE | time" for s in settings) + " |", "|---|" + "---|---|" * len(settings)]
    for i, scene in enumerate(SCENES):
        lines.append(f"| {scene} | " + " | ".join(f"{rows[s][i][0]:.2g} | {rows[s][i][1]:.2g}" for s in settings) + " |")
    means = [(mean(e for e, _ in rows[s]), mean(t / x for (_, t), (_, x) in zip(rows[s], rows[EXACT]))) for s in settings]
    return "\n".join([*lines, "| mean | " + " | ".join(f"{e:.2g} | 1/{1 / t:.2g}" for e, t in means) + " |"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lancer", default=os.path.join(ROOT, "build/release/bin/lancer"))
    only = parser.add_mutually_exclusive_group()
    only.add_argument("--derive", action="store_true", help="the settings alone")
    only.add_argument("--measure", action="store_true", help="what they take and bring alone")
    parser.add_argument("--print", action="store_true", help="leave the page as it is")
    options = parser.parse_args()
    lancer = os.path.abspath(options.lancer)
    parts = {}
    if not options.measure:
        parts["tests/bench/presets.py, derived"] = derived_table(swept(os.path.join(os.path.dirname(lancer), "bench_settings")))
    if not options.derive:
        parts["tests/bench/presets.py"] = measured_table(lancer)
    for name, text in parts.items():
        print(text)
        if not options.print:
            page_part.write(PAGE, name, text)


if __name__ == "__main__":
    main()
