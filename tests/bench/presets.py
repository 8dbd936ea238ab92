#!/usr/bin/env python3
"""Measures the presets of --quality in the gallery, for docs/cost-of-accuracy.md, or looks for better ones.

    tests/bench/presets.py [--search] [LANCER]        default: build/release/bin/lancer

With --search every setting of the grid below renders every gallery scene, and for each preset the cheapest
is printed whose error is no larger than what the preset aims at, both as geometric means over the scenes.
"""
import itertools
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
# What each preset is for, as an RMSE: 9, 2.5 and 0.9 steps of 8 bits.
AIMS = {"draft": 0.036, "normal": 0.01, "fine": 0.0035}
SAMPLES = [1, 2, 3, 4, 5, 6]
DEPTHS = [4, 8, 16, 32]
CONTRIBUTIONS = ["0.03", "0.01", "0.003"]
EXACT = ("--quality", "exact")


def render(lancer, scene, output, options):
    """Seconds of tracing, in one thread."""
    stats = output + ".json"
    subprocess.run([lancer, "render", os.path.join(ROOT, "scenes", "gallery", scene + ".lancer"), "--quiet", "--size", SIZE,
                    "--threads", "1", "-o", output, "--stats", stats, *options], check=True, stdout=subprocess.DEVNULL)
    with open(stats) as file:
        return json.load(file)["seconds"]["trace"]


def error(lancer, picture, truth):
    found = subprocess.run([lancer, "compare", picture, truth, "--json", "-"], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, check=False)
    return json.loads(found.stdout)["rmse"]


def options_of(samples, depth, contribution):
    sampling = [] if samples == 1 else ["--sampling", "sobol"]
    return ["--samples", str(samples), *sampling, "--max-depth", str(depth), "--min-contribution", contribution]


def mean(values):
    return math.exp(sum(math.log(v) for v in values) / len(values))


def measure(lancer, folder, settings):
    """{setting: [(rmse, seconds) of each scene]}, settings as command line options."""
    found = {setting: [] for setting in settings}
    picture, truth = os.path.join(folder, "picture.exr"), os.path.join(folder, "truth.exr")
    for scene in SCENES:
        render(lancer, scene, truth, ["--samples", "16", "--sampling", "sobol", "--seed", "7", "--max-depth", "1000",
                                      "--min-contribution", "1e-12"])
        for setting in settings:
            seconds = render(lancer, scene, picture, setting)
            found[setting].append((error(lancer, picture, truth), seconds))
        print(scene, file=sys.stderr)
    return found


def summary(found, setting):
    """Means over the scenes: RMSE, and time as a share of that of `exact`."""
    rows = found[setting]
    return mean([r for r, _ in rows]), mean([s / e for (_, s), (_, e) in zip(rows, found[EXACT])])


def table(found):
    settings = list(found)
    lines = ["| scene | " + " | ".join(f"{s[1]}: RMSE | time" for s in settings) + " |", "|---|" + "---|---|" * len(settings)]
    for i, scene in enumerate(SCENES):
        lines.append(f"| {scene} | " + " | ".join(f"{found[s][i][0]:.2g} | {found[s][i][1]:.2g}" for s in settings) + " |")
    means = [summary(found, s) for s in settings]
    return "\n".join(lines + ["| mean | " + " | ".join(f"{r:.2g} | 1/{1 / t:.2g}" for r, t in means) + " |"]) + "\n"


def main():
    search = "--search" in sys.argv[1:]
    names = [a for a in sys.argv[1:] if a != "--search"]
    lancer = os.path.abspath(names[0] if names else os.path.join(ROOT, "build/release/bin/lancer"))
    with tempfile.TemporaryDirectory(prefix="lancer-bench-") as folder:
        if not search:
            text = table(measure(lancer, folder, [("--quality", name) for name in [*AIMS, "exact"]]))
            page_part.write(PAGE, "tests/bench/presets.py", text)
            print(text)
            return
        grid = [tuple(options_of(*s)) for s in itertools.product(SAMPLES, DEPTHS, CONTRIBUTIONS)]
        found = measure(lancer, folder, [*grid, EXACT])
    for name, aim in AIMS.items():
        best = min((s for s in grid if summary(found, s)[0] <= aim), key=lambda s: summary(found, s)[1])
        print(f"{name}: {' '.join(best)}, RMSE {summary(found, best)[0]:.2g}, {1 / summary(found, best)[1]:.3g} times as fast as exact")


if __name__ == "__main__":
    main()
