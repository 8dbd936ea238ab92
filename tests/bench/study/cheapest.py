"""What --max-error takes beside the cheapest setting that holds the error, in rays; one to a light counts half."""
import csv
import subprocess

import measured

SIZE = "640x480"
ERRORS = ["0.01", "0.005"]
# Rays go deep in their glass: a sweep over settings at this size takes an hour.
SLOW = ["globe", "chess"]
SCENES = [s for s in measured.GALLERY if s not in SLOW]


def label(row):
    return f"{row['sampling']} {row['samples']} x {row['samples']}, depth {row['depth']}, contribution {row['contribution']}"


def table(rows):
    cells, ratios = [], {e: [] for e in ERRORS}
    for row in rows:
        cost, picture, deciding, printed = (float(row[k]) for k in ("cost", "picture", "deciding", "printed"))
        ratios[row["asked"]].append((picture + deciding) / cost)
        cells.append([row["scene"], row["asked"], label(row), f"{cost:.3g}", f"{picture:.3g}", f"{deciding:.2g} ({100 * deciding / (picture + deciding):.0f} %)",
                      f"{printed:.2g}", f"{ratios[row['asked']][-1]:.2f}", f"{float(row['made error']):.2g}"])
    for error in ERRORS:
        cells.append(["mean", error, "", "", "", "", "", f"{measured.mean(ratios[error]):.2f}", ""])
    return measured.table(["scene", "asked", "cheapest setting", "its rays", "picture", "to decide", "for the print", "of the cheapest", "error made"], cells)


def study(lancer, rounds):
    del rounds  # rays are counted
    paths = [measured.ROOT / "scenes" / "gallery" / f"{scene}.lancer" for scene in SCENES]
    done = subprocess.run([lancer.program.parent / "bench_settings", *SIZE.split("x"), ",".join(ERRORS), *paths], check=True, capture_output=True,
                          text=True)
    return table(list(csv.DictReader(done.stdout.splitlines()))), {}
