#!/usr/bin/env python3
"""What accuracy costs, knob by knob, over the gallery: makes the tables and plots of docs/study.md anew.

    tests/bench/study/study.py [--lancer build/release/bin/lancer] [--rounds N] [--only PART] [--print]

Parts: knobs, precision, depth, contribution, tolerance, adaptive, cheapest, calibration. The last three need bench_adaptive, bench_settings and
bench_calibration beside the program (-DBUILD_TESTING=ON). An hour on a machine that does nothing else.
"""
import argparse
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import adaptive  # noqa: E402
import calibration  # noqa: E402
import cheapest  # noqa: E402
import knobs  # noqa: E402
import limits  # noqa: E402
import measured  # noqa: E402
import number_types  # noqa: E402
import page_part  # noqa: E402

PAGE = measured.ROOT / "docs" / "study.md"
PARTS = {"knobs": knobs.study, "precision": number_types.study, "depth": limits.depth, "contribution": limits.contribution,
         "tolerance": limits.tolerance, "adaptive": adaptive.study, "cheapest": cheapest.study,
         "calibration": calibration.study}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lancer", default=str(measured.ROOT / "build" / "release" / "bin" / "lancer"))
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", choices=list(PARTS))
    parser.add_argument("--print", action="store_true", help="leave page and plots as they are")
    options = parser.parse_args()
    for name, part in PARTS.items():
        if options.only not in (None, name):
            continue
        with tempfile.TemporaryDirectory(prefix="lancer-study-") as folder:
            text, pictures = part(measured.Lancer(pathlib.Path(options.lancer).resolve(), folder), options.rounds)
        print(text)
        if not options.print:
            page_part.write(PAGE, f"tests/bench/study/study.py, {name}", text)
            for file, svg in pictures.items():
                (PAGE.parent / "pictures" / file).write_text(svg)


if __name__ == "__main__":
    main()
