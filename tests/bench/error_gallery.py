#!/usr/bin/env python3
"""What --max-error and --time keep in the gallery: writes its parts of docs/cost-of-accuracy.md.

    tests/bench/error_gallery.py [LANCER] [--only errors|times]        default: build/release/bin/lancer

Ten minutes on a machine that does nothing else.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(__file__))
import page_part

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAGE = os.path.join(ROOT, "docs", "cost-of-accuracy.md")
SCENES = ["mirror_hall", "knot", "teapot", "harbour", "globe", "gears", "orrery"]
ERRORS = ["0.01", "0.005"]
TIMES = [0.5, 1, 2, 5, 10, 20, 60]
TIMED = ["harbour", "mirror_hall", "teapot"]


def render(lancer, scene, folder, options):
    """Wall-clock seconds of the process, its exit code, and its statistics."""
    stats = os.path.join(folder, "stats.json")
    begin = time.perf_counter()
    done = subprocess.run([lancer, "render", os.path.join(ROOT, "scenes", "gallery", scene + ".lancer"), "--quiet",
                           "--size", "640x480", "-o", os.path.join(folder, "picture.png"), "--stats", stats, *options],
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    seconds = time.perf_counter() - begin
    if done.returncode not in (0, 1):
        return seconds, done.returncode, None
    with open(stats) as file:
        return seconds, done.returncode, json.load(file)["error"]


def by_error(lancer, folder):
    lines = ["| scene | asked | told (95 %) | rays a pixel | to decide | for the print |", "|---|---|---|---|---|---|"]
    for scene in SCENES:
        for asked in ERRORS:
            _, _, e = render(lancer, scene, folder, ["--max-error", asked])
            share = [f"{100 * e[k] / e['picture_rays']:.0f} %" for k in ("deciding_rays", "audit_rays")]
            told = f"{e['rmse']:.2g} ({e['low']:.2g} to {e['high']:.2g})" if e["rmse"] else "not told"
            lines.append(f"| {scene} | {asked} | {told} | {e['picture_rays'] / 640 / 480:.3g} | {share[0]} | {share[1]} |")
    return "\n".join(lines) + "\n"


def by_time(lancer, folder):
    lines = ["| scene | " + " | ".join(f"{t:g} s" for t in TIMES) + " |", "|---|" + "---|" * len(TIMES)]
    for scene in TIMED:
        cells = []
        for asked in TIMES:
            seconds, code, e = render(lancer, scene, folder, ["--time", f"{asked:g}"])
            cells.append("refused" if e is None else f"{seconds:.2f} s: {e['rmse'] or e['predicted']:.2g}" + ("" if code == 0 else ", late"))
        lines.append(f"| {scene} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("lancer", nargs="?", default=os.path.join(ROOT, "build/release/bin/lancer"))
    parser.add_argument("--only", choices=["errors", "times"])
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="lancer-bench-") as folder:
        for name, make in (("errors", by_error), ("times", by_time)):
            if options.only not in (None, name):
                continue
            text = make(os.path.abspath(options.lancer), folder)
            page_part.write(PAGE, f"tests/bench/error_gallery.py, {name}", text)
            print(text)


if __name__ == "__main__":
    main()
