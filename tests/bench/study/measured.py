"""Runs of Lancer, and errors of their pictures, for the study."""
import json
import math
import pathlib
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]
GALLERY = ["mirror_hall", "knot", "teapot", "harbour", "globe", "gears", "chess", "orrery"]
# Rays are followed until nothing is left, to show what a limit cuts.
UNCUT = ("--max-depth", "1000", "--min-contribution", "1e-12")


class Lancer:
    def __init__(self, program, folder):
        self.program, self.folder = program, pathlib.Path(folder)

    def render(self, scene, name, options):
        """The statistics of one run in one thread; the picture is `name` in the folder."""
        stats = self.folder / "stats.json"
        stats.unlink(missing_ok=True)
        done = subprocess.run([self.program, "render", ROOT / "scenes" / f"{scene}.lancer", "--quiet", "--threads", "1", "-o",
                               self.folder / name, "--stats", stats, *options], capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1):
            raise SystemExit(f"{scene} {' '.join(options)}: {done.stderr}")
        return json.loads(stats.read_text())

    def seconds(self, scene, name, options, rounds):
        """The median time of tracing."""
        return statistics.median(self.render(scene, name, options)["seconds"]["trace"] for _ in range(rounds))

    def compared(self, one, other):
        done = subprocess.run([self.program, "compare", self.folder / one, self.folder / other, "--json", "-"],
                              capture_output=True, text=True, check=False)
        return json.loads(done.stdout)

    def rmse(self, one, other):
        return self.compared(one, other)["rmse"]


def mean(values):
    """The geometric mean."""
    return math.exp(statistics.fmean(math.log(max(v, 1e-12)) for v in values))


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
                     + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"
