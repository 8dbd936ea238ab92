#!/usr/bin/env python3
"""Finds the values of --quality (model/quality.cpp) from measurements, and writes docs/cost-of-accuracy.md.

    tests/bench/presets.py [LANCER]        default: build/release/bin/lancer

Every setting of the grid below renders every gallery scene. Each preset has an error that it aims at; its
values are those of the cheapest setting whose error is no larger, both as geometric means over the scenes.
"""
import itertools
import json
import math
import os
import resource
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


def render(lancer, scene, output, options):
    """Seconds of the processor, all threads together."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([lancer, "render", os.path.join(ROOT, "scenes", "gallery", scene + ".lancer"), "--quiet", "--size", SIZE,
                    "-o", output, *options], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def error(lancer, picture, truth):
    found = subprocess.run([lancer, "compare", picture, truth, "--json", "-"], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, check=False)
    return json.loads(found.stdout)["rmse"]


def options_of(samples, depth, contribution):
    sampling = [] if samples == 1 else ["--sampling", "sobol"]
    return ["--samples", str(samples), *sampling, "--max-depth", str(depth), "--min-contribution", contribution]


def mean(values):
    return math.exp(sum(math.log(v) for v in values) / len(values))


def measure(lancer, folder):
    """{setting: [(rmse, seconds) of each scene]}, settings as command line options; `exact` among them."""
    settings = [tuple(options_of(*s)) for s in itertools.product(SAMPLES, DEPTHS, CONTRIBUTIONS)]
    settings.append(("--quality", "exact"))
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


def main():
    lancer = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build/release/bin/lancer"))
    with tempfile.TemporaryDirectory(prefix="lancer-bench-") as folder:
        found = measure(lancer, folder)
    exact = found[("--quality", "exact")]

    def summary(setting):
        rows = found[setting]
        return mean([r for r, _ in rows]), mean([s / e for (_, s), (_, e) in zip(rows, exact)])

    chosen = {}
    for name, aim in AIMS.items():
        good = [s for s in found if summary(s)[0] <= aim]
        chosen[name] = min(good, key=lambda s: summary(s)[1])
    chosen["exact"] = ("--quality", "exact")
    lines = ["| scene | " + " | ".join(f"{name}: RMSE | time" for name in chosen) + " |", "|---|" + "---|---|" * len(chosen)]
    for i, scene in enumerate(SCENES):
        lines.append(f"| {scene} | " + " | ".join(f"{found[s][i][0]:.2g} | {found[s][i][1]:.2g}" for s in chosen.values()) + " |")
    means = [summary(s) for s in chosen.values()]
    lines.append("| mean | " + " | ".join(f"{r:.2g} | 1/{1 / t:.2g}" for r, t in means) + " |")
    lines += ["", *(f"- `{name}`, cheapest of {len(found) - 1} settings with a mean RMSE of at most {AIMS[name]}: `{' '.join(s)}`"
                    for name, s in chosen.items() if name in AIMS)]
    page_part.write(PAGE, "tests/bench/presets.py", "\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
