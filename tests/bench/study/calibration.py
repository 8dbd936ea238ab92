"""Do the intervals hold the truth? The runs of bench_calibration as a table and a plot."""
import csv
import statistics
import subprocess

import measured
import plots

HEAD = ["picture", "asked", "told", "hold the truth", "RMSE within what was asked", "worst RMSE / asked", "rays a pixel",
        "to decide", "for the print"]


def read(program, seeds):
    """{(picture, asked): runs}, all values of a run as numbers."""
    done = subprocess.run([program, str(seeds)], check=True, capture_output=True, text=True)
    cells = {}
    for run in csv.DictReader(done.stdout.splitlines()):
        key = run.pop("picture"), run["asked"]
        cells.setdefault(key, []).append({name: float(value) for name, value in run.items()})
    return cells


def holds(run):
    return run["low"] <= run["error"] <= run["high"]


def row(picture, asked, runs):
    told = [r for r in runs if r["told"]]
    rays = (statistics.fmean(r[k] for r in runs) for k in ("picture rays", "deciding rays", "printed audit's rays"))
    return [picture, asked, str(len(told)), str(sum(map(holds, told))), str(sum(r["error"] <= r["asked"] for r in runs)),
            f"{max(r['error'] / r['asked'] for r in runs):.2f}", *(f"{r:.3g}" for r in rays)]


def study(lancer, rounds):
    cells = read(lancer.program.parent / "bench_calibration", 20 * rounds // 3)
    groups = {}
    for (picture, _), runs in cells.items():
        groups.setdefault(picture, []).extend((r["low"] / r["error"], r["high"] / r["error"]) for r in runs if r["told"])
    groups = {picture: pairs for picture, pairs in groups.items() if pairs}
    every = [pair for pairs in groups.values() for pair in pairs]
    held = sum(low <= 1 <= high for low, high in every)
    text = (measured.table(HEAD, [row(*key, runs) for key, runs in cells.items()])
            + f"\n{held} of {len(every)} intervals hold the truth ({100 * held / len(every):.1f} %).\n")
    return text, {"study_calibration.svg": plots.intervals("Printed intervals over true errors", groups)}
