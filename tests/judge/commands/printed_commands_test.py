#!/usr/bin/env python3
"""The commands that a report prints repeat what was done: printed_commands_test.py LANCER

Validates scenes with --report, runs what the page prints in a shell, and compares the numbers. Needs POV-Ray; without it
it exits with 77, which ctest calls skipped.
"""
import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SCENES = {
    # Brighter than 1, so that an exposure is needed; names that a shell would split; a param and a
    # camera.
    "a bright 'ball'.lancer": ("""
param n = 3
render { samples 3 min_contribution 0.05 }
camera other { position [0, 5, 1] look_at [0, 0, 0] }
camera front { position [0, 1, n] look_at [0, 0, 0] fov 40 }
light point { position [2, 4, 5] color [3, 3, 3] }
background [0.3, 0.5, 0.7]
material glass { color [1, 1, 1] transmission 0.03 ior 1.4 reflection 0.3 ambient 0.1 }
sphere { radius 0.7 material glass }
sphere { center [0.3, 0, -1.5] radius 0.6 material { color [0.9, 0.4, 0.2] } }
plane { normal [0, 1, 0] offset -0.7 material { color [0.9, 0.9, 0.8] } }
""", ["--camera", "front", "-D", "n=5"]),
}


def numbers(text):
    """`mean`, `max` and so on from what `lancer compare` prints."""
    return {key: float(value) for key, value in re.findall(r"^\s*(mean|rmse|max)\s+([0-9.e+-]+)", text, re.M)}


def main(lancer):
    if not (os.environ.get("LANCER_POVRAY") or shutil.which("povray")):
        print("NOT TESTED: the printed commands need POV-Ray")
        return 77
    for name, (script, options) in SCENES.items():
        with tempfile.TemporaryDirectory() as place:
            root = pathlib.Path(place)
            (root / name).write_text(script)
            subprocess.run([lancer, "validate", name, *options, "--size", "96x64", "--no-cache", "-q",
                            "--report", "report", "--json", "results.json"], cwd=root, check=False)
            result = json.loads((root / "results.json").read_text())["scenes"][0]
            page = (root / "report" / "index.html").read_text()
            commands = html.unescape(re.search(r"<h3>To repeat this</h3><pre>(.*?)</pre>", page, re.S).group(1))
            binaries = root / "bin"
            binaries.mkdir()
            (binaries / "lancer").symlink_to(lancer)
            if os.environ.get("LANCER_POVRAY"):
                (binaries / "povray").symlink_to(os.environ["LANCER_POVRAY"])
            environment = {**os.environ, "PATH": f"{binaries}:{os.environ['PATH']}"}
            run = subprocess.run(["sh", "-c", commands], cwd=root, env=environment, capture_output=True, text=True,
                                 check=False)
            found = numbers(run.stdout)
            assert set(found) == {"mean", "rmse", "max"}, f"{commands}\n{run.stdout}\n{run.stderr}"
            for key, value in found.items():
                # The accuracy of the printed digits, and of the 32 bits of an EXR file.
                assert abs(value - result[key]) <= 1e-3 * result[key] + 1e-7, (key, value, result[key], commands)
            assert result["exposure"] < 1, "the scene is meant to need an exposure"
            for beside in ("ours.png", "theirs.png", "difference.png"):
                assert list((root / "report").glob(f"*-{beside}")), beside
            assert len(list((root / "report").glob("*.pov"))) == 1
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(os.path.abspath(sys.argv[1])))
