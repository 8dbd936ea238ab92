#!/usr/bin/env python3
"""How much of the frontier of `lancer tradeoff` is the same in two runs over the gallery.

    tests/bench/frontier.py [--size 64x48] [LANCER] [--scenes NAME...]        default: build/release/bin/lancer

Prints for each scene how many settings are on both frontiers, and on one of them alone. Some minutes.
"""
import argparse
import json
import os
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENES = ["mirror_hall", "knot", "teapot", "harbour", "globe", "gears", "chess", "orrery"]


def frontier(lancer, scene, size, file):
    subprocess.run([lancer, "tradeoff", os.path.join(ROOT, "scenes", "gallery", scene + ".lancer"), "--size", size, "--threads", "1",
                    "--quiet", "--json", file], check=True)
    with open(file) as opened:
        page = json.load(opened)["scenes"][0]
    return {s["label"] for s in page["settings"] if s["frontier"]}, page["time_noise"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--size", default="64x48")
    parser.add_argument("--scenes", nargs="+", default=SCENES)
    parser.add_argument("lancer", nargs="?", default=os.path.join(ROOT, "build/release/bin/lancer"))
    options = parser.parse_args()
    lancer = os.path.abspath(options.lancer)
    both = either = 0
    print("| scene | on both frontiers | on one alone | noise of times |\n|---|---:|---|---:|")
    with tempfile.TemporaryDirectory(prefix="lancer-bench-") as folder:
        for scene in options.scenes:
            (a, first), (b, second) = (frontier(lancer, scene, options.size, os.path.join(folder, "t.json")) for _ in range(2))
            both += len(a & b)
            either += len(a | b)
            print(f"| {scene} | {len(a & b)} | {'; '.join(sorted(a ^ b)) or '-'} | {100 * first:.0f} %, {100 * second:.0f} % |", flush=True)
    print(f"| all | {both} | {either - both} ({100 * both / either:.0f} % the same) | |")


if __name__ == "__main__":
    main()
