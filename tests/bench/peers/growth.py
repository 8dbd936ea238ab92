#!/usr/bin/env python3
"""How the time of tracing grows: writes docs/pictures/growth.svg and the table in docs/performance.md.

    tests/bench/peers/growth.py [--lancer build/release/bin/lancer] [--rounds N] [--print]

One quantity grows, the others stay: number of balls, lights, depth of reflections, pixels, threads. The exponent is the
slope of the least squares line through the logarithms: 1 is in proportion, 0 is free. Ten minutes.
"""
import argparse
import math
import pathlib
import random
import statistics
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import page_part  # noqa: E402
import runs  # noqa: E402
from stage import Stage  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs" / "performance.md"
PLOT = ROOT / "docs" / "pictures" / "growth.svg"
SIDE = 512


def cloud(balls=10_000, lights=2, depth=4):
    """Balls in a cube that fill a sixth of it, whatever their number; a quarter of them are mirrors."""
    draw = random.Random(7).uniform
    stage = Stage((0.1, 0.2, 0.4), depth)
    stage.camera((2.2, 1.6, 2.6), (0, 0, 0), (0, 1, 0), 45)
    for _ in range(lights):
        stage.light([draw(-6, 6), draw(4, 8), draw(2, 8)], [1 / math.sqrt(lights)] * 3)
    stage.material("matt", (0.8, 0.5, 0.3), 0.1, 0.7)
    stage.material("mirror", (0.9, 0.9, 0.9), 0.1, 0.2, reflection=0.7)
    radius = (8 / 6 / balls * 3 / 4 / math.pi) ** (1 / 3)
    for i in range(balls):
        stage.sphere([draw(-1, 1) for _ in range(3)], radius, "mirror" if i % 4 == 0 else "matt")
    return stage


def between_mirrors(depth):
    """A ball between two mirrors that face each other: every reflection is followed."""
    stage = Stage((0, 0, 0), depth)
    stage.camera((0.9, 0.6, 1.5), (0, 0, -3), (0, 1, 0), 60)
    stage.light((1, 3, 1), (1, 1, 1))
    stage.material("mirror", (1, 1, 1), 0, 0.02, reflection=0.97)
    stage.material("matt", (0.3, 0.8, 0.5), 0.1, 0.7)
    stage.plane((0, 0, 1), -3, "mirror")
    stage.plane((0, 0, -1), -3, "mirror")
    stage.plane((0, 1, 0), -1, "matt")
    stage.sphere((0, 0, -1), 0.7, "matt")
    return stage


# The quantity that grows, its values, the scene for a value, the picture's side, threads.
AXES = [
    ("balls", [100, 1_000, 10_000, 100_000, 1_000_000, 3_162_278], lambda n: cloud(balls=n), None, None),
    ("lights", [1, 2, 4, 8, 16, 32, 64], lambda n: cloud(lights=n), None, None),
    ("depth of reflections", [1, 2, 4, 8, 16, 32, 64], between_mirrors, None, None),
    ("pixels", [64**2, 128**2, 256**2, 512**2, 1024**2, 2048**2], lambda n: cloud(), math.isqrt, None),
    ("threads", [1, 2], lambda n: cloud(), None, int),
]


def seconds(options, stage, side, threads):
    """The median time of tracing."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "scene.lancer").write_text("\n".join(stage.lancer) + "\n")
        return statistics.median(runs.lancer(options.lancer, folder, side, 1, threads).trace
                                 for _ in range(options.rounds))


def exponent(values, times):
    xs, ys = [math.log(v) for v in values], [math.log(t) for t in times]
    mx, my = statistics.fmean(xs), statistics.fmean(ys)
    return sum((x - mx) * (y - my) for x, y in zip(xs, ys)) / sum((x - mx) ** 2 for x in xs)


def panel(left, name, values, times, slope):
    """One plot of 220 x 180 pixels: both axes logarithmic."""
    width, height, top = 150, 110, 30
    low, high = math.log(values[0]), math.log(values[-1])
    least, most = math.log(min(times)), math.log(max(max(times), 1.3 * min(times)))
    def at(v, t):
        return (left + 52 + width * (math.log(v) - low) / (high - low),
                top + height - height * (math.log(t) - least) / (most - least))
    points = [at(v, t) for v, t in zip(values, times)]
    out = [f'<rect x="{left + 52}" y="{top}" width="{width}" height="{height}" class="frame"/>',
           f'<text x="{left + 52 + width / 2}" y="18" class="title">{name}: exponent {slope:.2f}</text>',
           f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in points)}" class="line"/>']
    out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3"/>' for x, y in points]
    for v, anchor in ((values[0], "start"), (values[-1], "end")):
        out.append(f'<text x="{at(v, times[0])[0]:.1f}" y="{top + height + 16}" text-anchor="{anchor}">{v:,}</text>')
    for t in (min(times), max(times)):
        out.append(f'<text x="{left + 48}" y="{at(values[0], t)[1] + 4:.1f}" text-anchor="end">{t:.2g} s</text>')
    return out


def plot(rows):
    style = ("<style>text{font:12px sans-serif;fill:#444}.title{text-anchor:middle;font-weight:bold}"
             ".frame{fill:none;stroke:#888}.line{fill:none;stroke:#1f6fb2;stroke-width:2}circle{fill:#1f6fb2}"
             "@media (prefers-color-scheme:dark){text{fill:#ccc}.line{stroke:#6fb7f0}circle{fill:#6fb7f0}}</style>")
    width = 220 * len(rows)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} 165" role="img">',
             "<title>Time of tracing as one quantity grows; both axes are logarithmic</title>", style]
    for i, (name, values, times, slope) in enumerate(rows):
        parts += panel(220 * i, name, values, times, slope)
    return "\n".join(parts + ["</svg>"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lancer", default=str(ROOT / "build" / "release" / "bin" / "lancer"))
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--print", action="store_true", help="leave page and plot as they are")
    options = parser.parse_args()
    options.lancer = str(pathlib.Path(options.lancer).resolve())
    rows, lines = [], ["| what grows | from | to | exponent | times at each, s |", "|---|---:|---:|---:|---|"]
    for name, values, scene, side_of, threads_of in AXES:
        times = [seconds(options, scene(v), side_of(v) if side_of else SIDE, threads_of(v) if threads_of else 1)
                 for v in values]
        slope = exponent(values, times)
        rows.append((name, values, times, slope))
        lines.append(f"| {name} | {values[0]:,} | {values[-1]:,} | {slope:.2f} | "
                     + ", ".join(f"{t:.3g}" for t in times) + " |")
        print(lines[-1], flush=True)
    if not options.print:
        PLOT.write_text(plot(rows))
        page_part.write(PAGE, "tests/bench/peers/growth.py", "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
