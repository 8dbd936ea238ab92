"""One run of each program: seconds of tracing, seconds of the whole process, peak memory, and the picture."""
import json
import re
import subprocess
import time
from collections import namedtuple

# The largest scene is a text of 60 MB.
LIMITS = ["--limit-source-bytes", str(2**30)]
Run = namedtuple("Run", "trace whole memory picture")


def timed(command, folder):
    """Seconds from start to end, the peak of memory in bytes, and what the command printed."""
    kilobytes = folder / "memory"
    # GNU time measures the memory: a child of this process would be charged with this one's.
    command = ["/usr/bin/time", "-f", "%M", "-o", kilobytes, *command]
    begin = time.monotonic()
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace")
    seconds = time.monotonic() - begin
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))} failed:\n{done.stdout[-2000:]}")
    return seconds, int(kilobytes.read_text()) * 1024, done.stdout


def lancer(program, folder, side, samples, threads, level=None):
    stats = folder / "stats.json"
    held = ["--level", level] if level else []
    whole, memory, _ = timed([program, "render", "scene.lancer", "--size", f"{side}x{side}", "--samples", str(samples),
                              "--threads", str(threads), "--bits", "16", "--linear", "-q", "--stats", stats,
                              "-o", "lancer.ppm", *held, *LIMITS],
                             folder)
    return Run(json.loads(stats.read_text())["seconds"]["trace"], whole, memory, folder / "lancer.ppm")


def povray(program, folder, side, samples, threads):
    """POV-Ray renders every sample as a pixel: the same rays, and blocks of its picture are Lancer's pixels."""
    size = side * samples
    whole, memory, text = timed([program, "+Iscene.pov", "+Opovray.ppm", f"+W{size}", f"+H{size}", "+FP16",
                                 "File_Gamma=1.0", "-D", "-A",
                                 f"+WT{threads}", "-GD", "-GR"], folder)
    seconds = re.search(r"Trace Time:.*\(([0-9.]+) seconds\)", text)
    return Run(float(seconds[1]), whole, memory, folder / "povray.ppm")


def tachyon(program, folder, side, samples, threads):
    size = side * samples
    whole, memory, text = timed([program, "scene.dat", "-res", str(size), str(size), "-numthreads", str(threads),
                                 "-shade_phong", "-format", "PPM48", "-o", "tachyon.ppm", "+V"], folder)
    seconds = re.search(r"Ray Tracing Time:\s*([0-9.]+)", text)
    return Run(float(seconds[1]), whole, memory, folder / "tachyon.ppm")
