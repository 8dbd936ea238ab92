#!/usr/bin/env python3
"""The bare search beside Embree's, a grid and no structure: writes its part of docs/performance.md.

    apt-get install libembree-dev
    cmake --preset release -DBUILD_TESTING=ON && cmake --build build/release --target bench_search
    tests/bench/search/search.py [BENCH_SEARCH]
"""
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, os.path.join(ROOT, "tests", "bench"))
import page_part  # noqa: E402


def main():
    bench = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "release" / "bin" / "bench_search"
    text = subprocess.run([bench], capture_output=True, text=True, check=True).stdout
    page_part.write(ROOT / "docs" / "performance.md", "tests/bench/search/search.py", text.rstrip() + "\n")


if __name__ == "__main__":
    main()
