#!/usr/bin/env python3
"""Measures pictures in parts, for docs/many-machines.md.

    tests/bench/parts.py LANCER workers [SECONDS]   12 parts of each gallery scene, pictures that take one worker SECONDS (60):
                                                    two real workers, and four simulated from the parts' processor times
    tests/bench/parts.py LANCER counts [WORKERS]    how many times one worker 4 (WORKERS) are with 4 to 48 parts, by rays
    tests/bench/parts.py LANCER errors              rays of parts by an error beside those of the whole
    tests/bench/parts.py LANCER poster [SIDE [png] [exr]]   memory and time of joining SIDE x SIDE pixels (32768) of black
    tests/bench/parts.py LANCER drawn SCENE [SIDE]  the same of parts that are drawn, and the memory of drawing one
    tests/bench/parts.py LANCER kills [COUNT]       COUNT kills (100) at random moments over parts, frames and a sweep

Times are the processor's, on one thread: they depend little on what else the machine does, unlike those of a clock, by which
two real workers are measured.
"""
import hashlib
import heapq
import json
import math
import os
import random
import signal
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GALLERY = sorted((ROOT / "scenes" / "gallery").glob("*.lancer"))
LANCER = ""


def run(*words, codes=(0,), **more):
    """Processor seconds and peak memory in bytes of one run, and what it printed."""
    process = subprocess.Popen([LANCER, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **more)
    text = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in codes:
        sys.exit(f"lancer {' '.join(map(str, words))}: exit code {process.returncode}\n{text}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, text


def makespan(times, workers):
    """Each worker takes the next part when it is free, as the tasks of an array are dealt."""
    free = [0.0] * workers
    for t in times:
        heapq.heapreplace(free, free[0] + t)
    return max(free)


def fixed_cost(scene):
    cost = json.loads(run("info", "--json", scene)[2])["fixed_cost"]
    return sum(cost.values())


def drawn_by(workers, scene, folder, size, count=12):
    """Seconds by the clock, and the parts' own processor times: so many processes, each with one thread, take the next of
    `count` parts when they are free."""
    waiting, running, times = list(range(1, count + 1)), {}, {}
    begun = time.monotonic()
    while waiting or running:
        while waiting and len(running) < workers:
            k = waiting.pop(0)
            process = subprocess.Popen([LANCER, "render", str(scene), "--threads", "1", "-q", "--size", size, "--part",
                                        f"{k}/{count}", "-o", str(folder / f"{k}.exr")])
            running[process.pid] = k, process
        pid, status, usage = os.wait4(-1, 0)
        k, process = running.pop(pid)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{scene}: part {k} ended with {process.returncode}")
        times[k] = usage.ru_utime + usage.ru_stime
    return time.monotonic() - begun, [times[k] for k in range(1, count + 1)]


def workers(seconds=60):
    """12 parts at a size at which one worker needs about that many seconds: by two real workers, and by four from the times
    of the parts drawn one by one. One worker is a whole render with one thread, the mean of one before and one after."""
    print("| scene | size | fixed cost of each part, s | one worker, s | two workers, s | times one | four, from the parts' times |")
    print("|---|---|---|---|---|---|---|", flush=True)
    least_two = least_four = 99.0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for scene in GALLERY:
            def whole(size):
                """By the clock, and by the processor."""
                begun = time.monotonic()
                cost = run("render", scene, "--threads", 1, "-q", "--size", size, "-o", folder / "whole.png")[0]
                return time.monotonic() - begun, cost
            fixed = fixed_cost(scene)
            per_pixel = max(0.01, whole("512x384")[1] - fixed) / (512 * 384)
            side = 16 * round(math.sqrt(max(1, seconds - fixed) / per_pixel * 3 / 4) / 16)
            size = f"{4 * side // 3}x{side}"
            first = whole(size)
            two, _ = drawn_by(2, scene, folder, size)
            _, parts = drawn_by(1, scene, folder, size)
            one, one_cost = ((a + b) / 2 for a, b in zip(first, whole(size)))
            run("join", "-q", *[folder / f"{k}.exr" for k in range(1, 13)], "-o", folder / "joined.png")
            if (folder / "joined.png").read_bytes() != (folder / "whole.png").read_bytes():
                sys.exit(f"{scene}: joined parts are not the whole")
            four = one_cost / makespan(parts, 4)
            least_two, least_four = min(least_two, one / two), min(least_four, four)
            print(f"| {scene.stem} | {size} | {fixed:.3f} | {one:.1f} | {two:.1f} | {one / two:.2f} | {four:.2f} |", flush=True)
    print(f"\nthe least: {least_two:.2f} times one worker by two, {least_four:.2f} by four")


def counts(workers=4, seconds=60):
    """By the rays of each part, which no other load changes: a part of a picture that one worker draws in 60 s takes the
    fixed cost and its share of the rays. Strips are as high, against the picture, as those of 768 rows, or higher."""
    numbers = (4, 8, 12, 24, 48)
    print("| scene | fixed cost, s | " + " | ".join(f"{n} parts" for n in numbers) + " |\n|" + "---|" * (2 + len(numbers)))
    with tempfile.TemporaryDirectory() as folder:
        stats = Path(folder) / "s.json"
        for scene in GALLERY:
            fixed, row = fixed_cost(scene), []
            for n in numbers:
                rays = []
                for k in range(1, n + 1):
                    run("render", scene, "-q", "--size", "512x384", "--samples", 1, "--part", f"{k}/{n}", "--stats", stats,
                        "-o", Path(folder) / "a.exr")
                    rays.append(sum(json.loads(stats.read_text())["rays"].values()))
                times = [fixed + (seconds - fixed) * r / sum(rays) for r in rays]
                row.append(seconds / makespan(times, workers))
            print(f"| {scene.stem} | {fixed:.3f} | " + " | ".join(f"{t:.2f}" for t in row) + " |", flush=True)


def errors():
    print("| scene | asked | rays a pixel, whole | 4 parts | 12 parts | audits, whole | 4 parts | 12 parts | RMSE, whole | 4 parts | 12 parts |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for scene in GALLERY:
            rays, audits, told = [], [], []
            for count in (1, 4, 12):
                names = [Path(folder) / f"{k}.exr" for k in range(1, count + 1)]
                own = other = 0
                for k, name in enumerate(names, 1):
                    run("render", scene, "--size", "640x480", "--max-error", 0.01, "--part", f"{k}/{count}", "-q",
                        "--stats", Path(folder) / "s.json", "-o", name, codes=(0, 1))
                    stats = json.loads((Path(folder) / "s.json").read_text())["error"]
                    own += stats["picture_rays"]
                    other += stats["audit_rays"] + stats["deciding_rays"]
                text = run("join", *names, "-o", Path(folder) / "a.png", codes=(0, 1))[2]
                rays.append(f"{own / 307200:.2f}")
                audits.append(f"{other / 307200:.2f}")
                told.append(text.splitlines()[-1].split(", asked")[0].removeprefix("RMSE "))
            print(f"| {scene.stem} | 0.01 | " + " | ".join(rays + audits + told) + " |", flush=True)


def black_part(path, number, count, side):
    """A part of a black picture, laid out as model/io/part_layout.cpp does, with holes in place of its zeros: drawing and
    storing 26 GB would take an hour and tell nothing about the joining."""
    def attribute(name, kind, value):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value

    rows = max(1, min(16, side // (4 * count)))
    strips = [(first, min(rows, side - first)) for first in range(rows * (number - 1), side, rows * count)]
    text = (f"lancer part 1\npart {number} {count}\nsize {side} {side}\nextra\n"
            f"scene black\nbuild of the bench\noptions size {side}x{side}\n").encode()
    row_bytes, all_rows = 24 * side, sum(n for _, n in strips)
    digest = hashlib.sha256(text)
    zeros = bytes(row_bytes)
    for _ in range(all_rows):
        digest.update(zeros)
    text += f"seal {digest.hexdigest()}\n".encode()
    channels = b"".join(name.encode() + b"\0" + struct.pack("<4i", kind, 0, 1, 1) for name, kind in (
        ("B", 2), ("G", 2), ("R", 2), ("exact.B", 0), ("exact.G", 0), ("exact.R", 0))) + b"\0"
    head = b"\x76\x2F\x31\x01\x02\x10\0\0"
    for index, (first, n) in enumerate(strips):
        head += b"" if index else attribute("lancer:part", "string", text)
        head += attribute("channels", "chlist", channels) + attribute("chunkCount", "int", struct.pack("<i", n))
        head += attribute("compression", "compression", b"\0")
        head += attribute("dataWindow", "box2i", struct.pack("<4i", 0, first, side - 1, first + n - 1))
        head += attribute("displayWindow", "box2i", struct.pack("<4i", 0, 0, side - 1, side - 1))
        head += attribute("lineOrder", "lineOrder", b"\0") + attribute("name", "string", f"rows from {first}".encode())
        head += attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
        head += attribute("screenWindowCenter", "v2f", bytes(8)) + attribute("screenWindowWidth", "float", struct.pack("<f", 1))
        head += attribute("type", "string", b"scanlineimage") + b"\0"
    head += b"\0"
    begin = len(head) + 8 * all_rows
    head += b"".join(struct.pack("<Q", begin + i * (12 + row_bytes)) for i in range(all_rows))
    with open(path, "wb") as file:
        file.write(head)
        at = begin
        for index, (first, n) in enumerate(strips):
            for y in range(first, first + n):
                file.seek(at)
                file.write(struct.pack("<3i", index, y, row_bytes))
                at += 12 + row_bytes
        file.truncate(at)


def tell_joining(names, folder, ending):
    begun = time.monotonic()
    cost, memory, text = run("join", *names, "-o", folder / f"poster.{ending}")
    print(f"join to {ending}: {memory / 1e6:.0f} MB at the most, {cost:.0f} s of the processor, "
          f"{time.monotonic() - begun:.0f} s; {text.strip()}", flush=True)


def poster(side=32768, *endings):
    count = 32
    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR", "/tmp")) as folder:
        folder = Path(folder)
        names = [folder / f"{k}.exr" for k in range(1, count + 1)]
        (folder / "black.lancer").write_text("camera { position [0, 0, 5] look_at [0, 0, 0] }\n")
        # Checks that these parts are what a run would draw.
        for n, this_side in ((count, 256), (count, side)):
            for k, name in enumerate(names, 1):
                black_part(name, k, n, this_side)
            if this_side == 256:
                run("join", *names, "-o", folder / "a.png")
                run("render", folder / "black.lancer", "--size", "256x256", "-q", "-o", folder / "b.png")
                if (folder / "a.png").read_bytes() != (folder / "b.png").read_bytes():
                    sys.exit("these are no parts of a black picture")
        print(f"{count} parts of {side} x {side} pixels: {sum(n.stat().st_size for n in names) / 1e9:.1f} GB", flush=True)
        for ending in endings or ("png",):
            tell_joining(names, folder, ending)
            (folder / f"poster.{ending}").unlink()


def drawn(scene, side=32768, count=32):
    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR", "/tmp")) as name:
        folder, most, total, begun = Path(name), 0, 0.0, time.monotonic()
        names = [folder / f"{k}.exr" for k in range(1, count + 1)]
        for k, part in enumerate(names, 1):
            cost, memory, _ = run("render", scene, "-q", "--size", f"{side}x{side}", "--samples", 1, "--part", f"{k}/{count}",
                                  "-o", part)
            most, total = max(most, memory), total + cost
        print(f"{count} parts of {side} x {side} pixels: {sum(n.stat().st_size for n in names) / 1e9:.1f} GB, {most / 1e6:.0f} MB "
              f"at the most, {total:.0f} s of the processor, {time.monotonic() - begun:.0f} s", flush=True)
        tell_joining(names, folder, "png")


BALL = """camera { position [0, 1, 5] look_at [0, 0, 0] }
light point { position [4, 6, 3] }
plane { normal [0, 1, 0] offset -1 material { color [0.5, 0.4, 0.3] } }
sphere { radius 1 + 0.02 * frame material { reflection 0.3 } }
"""


def digests(folder):
    """Of every file that has its name, not the temporary one under which it is written."""
    return {path: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(folder.rglob("*"))
            if path.is_file() and not path.name.startswith(".")}


def kills(count=100):
    chance = random.Random(7)
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / "a.lancer").write_text(BALL)
        work = folder / "work"
        work.mkdir()
        environment = {**os.environ, "LANCER_CACHE": str(work / "cache")}
        size = ("--size", "320x240")
        jobs = {f"part {k}": ("render", folder / "a.lancer", *size, "--samples", 3, "--resume", "--part", f"{k}/3",
                              "-o", work / f"p{k}.exr") for k in (1, 2, 3)}
        jobs |= {f"part by an error {k}": ("render", folder / "a.lancer", *size, "--max-error", 0.004, "--resume",
                                           "--part", f"{k}/2", "-o", work / f"e{k}.exr") for k in (1, 2)}
        jobs |= {f"frames {k}": ("render", folder / "a.lancer", "--frames", "1..6", *size, "--resume", "--part", f"{k}/2",
                                 "-o", work / "f-%d.png") for k in (1, 2)}
        jobs |= {f"sweep {k}": ("stability", folder / "a.lancer", "--no-povray", "--size", "120x90", "--part", f"{k}/2")
                 for k in (1, 2)}
        # The result and the duration of each job when nothing is killed.
        lengths = {}
        for name, job in jobs.items():
            begun = time.monotonic()
            run(*job, env=environment)
            lengths[name] = time.monotonic() - begun
        right = digests(work)
        for path in right:
            path.unlink()
        hit, there = 0, {}
        names = list(jobs)
        for i in range(count):
            name = names[i % len(names)]
            # Everything written before must still exist; sometimes a file is deleted, to be made
            # again.
            for path in list(there):
                if chance.random() < 0.3:
                    path.unlink()
            before = digests(work)
            process = subprocess.Popen(list(map(str, [LANCER, *jobs[name]])), env=environment, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.PIPE, text=True)
            time.sleep(chance.random() * lengths[name])
            process.send_signal(signal.SIGKILL)
            _, said = process.communicate()
            hit += process.returncode == -signal.SIGKILL
            if "drawn again" in said:
                sys.exit(f"kill {i}, {name}: {said}")
            there = digests(work)
            for path, digest in there.items():
                if right.get(path) != digest:
                    sys.exit(f"kill {i}, {name}: {path.name} is not what it should be")
            for path in before:
                if path not in there:
                    sys.exit(f"kill {i}, {name}: {path.name} is lost")
        for name, job in jobs.items():
            text = run(*job, env=environment)[2]
            if "drawn again" in text:
                sys.exit(f"{name}: {text}")
        if digests(work) != right:
            sys.exit("in the end the files are not those that they should be")
        for letter, parts, more in (("p", 3, ("--samples", 3)), ("e", 2, ())):
            run("join", "-q", *[work / f"{letter}{k}.exr" for k in range(1, parts + 1)], "-o", folder / f"{letter}.png")
            if more:
                run("render", folder / "a.lancer", *size, *more, "-q", "-o", folder / "whole.png")
                if (folder / f"{letter}.png").read_bytes() != (folder / "whole.png").read_bytes():
                    sys.exit("joined parts are not the whole")
        sweep = ("stability", folder / "a.lancer", "--no-povray", "--size", "120x90", "--json")
        run(*sweep, folder / "kept.json", env=environment)
        run(*sweep, folder / "anew.json", "--no-cache", env=environment)
        if (folder / "kept.json").read_text() != (folder / "anew.json").read_text():
            sys.exit("the sweep's report is not that of a run without a cache")
        left = [p.name for p in work.rglob("*") if p.is_file() and p not in right]
        print(f"{count} kills, {hit} of them in the middle of a run: nothing lost, nothing wrong; left behind: {left or 'nothing'}")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    LANCER = os.path.abspath(sys.argv[1])
    what = {"workers": workers, "counts": counts, "errors": errors, "poster": poster, "drawn": drawn, "kills": kills}.get(sys.argv[2])
    if what is None:
        sys.exit(__doc__)
    what(*[int(word) if word.isdigit() else word for word in sys.argv[3:]])
