#!/usr/bin/env python3
"""The kernels against 256 bits: writes the table in docs/accuracy.md.

    tests/oracle/table.py [FOLDER [RAYS]]      default: build/dev/bin, a million rays a shape
"""
import os
import subprocess
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "tests", "bench"))
import page_part  # noqa: E402

PAGE = os.path.join(ROOT, "docs", "accuracy.md")
HEAD = ("| shape | crossings | worst error of t | median bound | used | point off, worst | its bound used | "
        "normal, worst | case |\n|---|---|---|---|---|---|---|---|---|\n")


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "build", "dev", "bin")
    rays = sys.argv[2] if len(sys.argv) > 2 else "1000000"
    environment = dict(os.environ, LANCER_ORACLE_RAYS=rays)
    rows = f"{int(rays):,} rays a shape:\n\n" + HEAD
    for test in ("solids_oracle_test", "splines_oracle_test"):
        run = subprocess.run([os.path.join(folder, test)], env=environment, capture_output=True, text=True)
        rows += "".join(line + "\n" for line in run.stdout.splitlines() if line.startswith("| "))
        if run.returncode != 0:
            sys.exit(run.stdout)
    page_part.write(PAGE, "tests/oracle/table.py", rows)


if __name__ == "__main__":
    main()
