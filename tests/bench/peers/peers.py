#!/usr/bin/env python3
"""Lancer beside POV-Ray and Tachyon: writes the table in docs/performance.md.

    tests/bench/peers/peers.py [--lancer build/release/bin/lancer] [--level L] [--threads N] [--rounds N] [--only WORD]
                               [--print]

Each scene of scenes.py is rendered by the three programs in turn; the times are medians, the ratios medians of the
ratios within a round. The pictures must agree, or there is no row. With --level the processor is held to that level of
instructions, and the table is another one of the page. Needs the packages povray, tachyon and time; half an hour.
"""
import argparse
import functools
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import page_part  # noqa: E402
import pictures  # noqa: E402
import runs  # noqa: E402
import scenes  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs" / "performance.md"
# Blocks of 16 x 16 pixels: Tachyon's samples lie half a pixel from Lancer's, POV-Ray's meshes are in single precision.
BLOCK, MOST_RMSE = 16, 0.01


def prepared(options, what, side, samples, folder):
    """Writes the scene for all programs; says whether Tachyon can render it."""
    if isinstance(what, str):
        shutil.copytree(ROOT / "scenes" / "gallery", folder, dirs_exist_ok=True)
        shutil.copy(folder / f"{what}.lancer", folder / "scene.lancer")
        can_tachyon = False
    else:
        stage = what(folder)
        stage.write(folder, side, side)
        can_tachyon = stage.can_tachyon
    size = side * samples
    subprocess.run([options.lancer, "export", "scene.lancer", "--size", f"{size}x{size}", "-o", "scene.pov", "-q",
                    *runs.LIMITS], cwd=folder, check=True, stderr=subprocess.DEVNULL)
    return can_tachyon and shutil.which("tachyon") is not None


def agreement(ours, theirs, samples):
    """RMSE of block means; a peer that draws another picture is no peer."""
    error = pictures.rmse(ours.picture, BLOCK, theirs.picture, BLOCK * samples)
    if not error <= MOST_RMSE:
        raise RuntimeError(f"{theirs.picture.stem} draws another picture: RMSE {error:.4f} of blocks")
    return error


def measured(options, what, side, samples):
    """The runs of each program, by name, and how far its picture is from Lancer's."""
    lancer = functools.partial(runs.lancer, level=options.level)
    programs = {"lancer": (lancer, options.lancer), "povray": (runs.povray, "povray"),
                "tachyon": (runs.tachyon, "tachyon")}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if not prepared(options, what, side, samples, folder):
            del programs["tachyon"]
        taken = {program: [] for program in programs}
        for _ in range(options.rounds):
            for program, (run, path) in programs.items():
                taken[program].append(run(path, folder, side, samples, options.threads))
        errors = {program: agreement(taken["lancer"][0], taken[program][0], samples)
                  for program in programs if program != "lancer"}
    return taken, errors


def median(taken, program, field):
    return statistics.median(getattr(run, field) for run in taken[program])


def ratio(taken, program, field):
    """How many times as long as Lancer the program takes: the median of the rounds."""
    return statistics.median(getattr(theirs, field) / getattr(ours, field)
                             for ours, theirs in zip(taken["lancer"], taken[program]))


def row(name, side, taken, errors):
    cells = [name, f"{side}²"]
    for field, form in (("trace", "{:.2f}"), ("whole", "{:.2f}")):
        cells.append(form.format(median(taken, "lancer", field)))
        for program in ("povray", "tachyon"):
            cells.append(f"{ratio(taken, program, field):.2f}" if program in taken else "")
    cells.append(" / ".join(f"{median(taken, p, 'memory') / 1e6:.0f}" for p in taken))
    cells.append(" / ".join(f"{error:.4f}" for error in errors.values()))
    return "| " + " | ".join(cells) + " |"


def means(all_taken, field):
    """The geometric mean over the scenes, and the least, for each peer."""
    for program, said in (("povray", "POV-Ray"), ("tachyon", "Tachyon")):
        ratios = [ratio(taken, program, field) for taken in all_taken if program in taken]
        if ratios:
            yield (f"{said} takes {math.exp(statistics.fmean(map(math.log, ratios))):.2f} times Lancer's "
                   f"{'time of tracing' if field == 'trace' else 'whole time'} (geometric mean of {len(ratios)} "
                   f"scenes), {min(ratios):.2f} at least.")


def processor():
    with open("/proc/cpuinfo") as file:
        return next((line.split(":")[1].strip() for line in file if line.startswith("model name")), "unknown")


def level(lancer):
    text = subprocess.run([lancer, "info", ROOT / "scenes" / "ten_lines.lancer"], check=True, capture_output=True,
                          text=True).stdout
    return next((line.split()[1].rstrip(":") for line in text.splitlines() if line.startswith("level")), "unknown")


def counted(number, what):
    return f"{number} {what}{'' if number == 1 else 's'}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lancer", default=str(ROOT / "build" / "release" / "bin" / "lancer"))
    parser.add_argument("--level", help="what `lancer render --level` takes; without it the best that there is")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", default="", help="scenes whose name holds this")
    parser.add_argument("--print", action="store_true", help="leave the page as it is")
    options = parser.parse_args()
    options.lancer = str(pathlib.Path(options.lancer).resolve())
    lines = ["| scene | pixels | Lancer traces, s | POV-Ray, times | Tachyon, times | Lancer in all, s | POV-Ray, times "
             "| Tachyon, times | MB: Lancer / POV-Ray / Tachyon | apart |", "|---|" + "---:|" * 9]
    all_taken = []
    for name, what, side, samples in scenes.ALL:
        if options.only not in name:
            continue
        taken, errors = measured(options, what, side, samples)
        all_taken.append(taken)
        lines.append(row(name, side, taken, errors))
        print(lines[-1], flush=True)
    told = [sentence for field in ("trace", "whole") for sentence in means(all_taken, field)]
    print("\n".join(told))
    if not options.print:
        held = options.level or level(options.lancer)
        text = (f"{processor()}, level `{held}`, {counted(options.threads, 'thread')}, medians of "
                f"{counted(options.rounds, 'round')}.\n\n")
        part = "tests/bench/peers/peers.py" + (f" --level {options.level}" if options.level else "")
        page_part.write(PAGE, part, text + "\n".join(lines) + "\n\n" + "\n".join(told) + "\n")


if __name__ == "__main__":
    main()
