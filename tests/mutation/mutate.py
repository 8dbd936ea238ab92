#!/usr/bin/env python3
"""Would `lancer validate` notice a wrong number? Changes literals of the exporter and the shader, one at a time, and asks.

    tests/mutation/mutate.py [--seed 1] [--count 30] [--folder DIR] [--list]

Works on a copy of the sources. Draws `count` literals, builds `lancer` with each of them changed, and validates the
scenes until one fails. A literal is

  - a number, or `true` or `false`, in code: a whole number grows by one, another by a quarter, a truth is turned over;
  - a text that the exporter writes: the first number in it is changed like that, or its first word is misspelt.

Not drawn, because no picture depends on them or none should: comments, preprocessor lines, assertions; comments inside
the .pov file; the words of messages to the user (refusals, approximations, FileErrors) and the conditions for them;
initial and default values; bounds of rounding errors and guards against it (a comparison with 0, a value clamped);
the notes that only `explain` reads.
Exits with 1 when fewer than all but one are noticed.
"""
import argparse
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
WRITER = ["reference/pov/*.cpp", "reference/pov/*.h"]
TALKERS = ["differences", "coincidence", "export"]  # find and name what to warn of, and write no line of the scene
SHADER = ["tracer/whitted.h", "tracer/optics.h", "tracer/lights.h", "tracer/shadow.h", "tracer/media.h",
          "tracer/surface.h", "tracer/texture.h", "tracer/camera.h", "tracer/textures/*.h", "tracer/textures/*.cpp"]
# Quick ones first: most mutants fall at the first.
SCENES = ["materials", "lights", "shapes", "textures", "glass", "media", "cameras", "language", "gallery"]

TOKEN = re.compile(r'''
    (?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#[^\n]*|'(?:\\.|[^'\\])+')
  | (?P<text>"(?:\\.|[^"\\])*")
  | (?P<word>[A-Za-z_]\w*)
  | (?P<number>(?:0[xX][0-9a-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?P<suffix>[uUlLfF]*))
''', re.VERBOSE | re.MULTILINE | re.DOTALL)
MESSAGE = re.compile(r"(static_assert|assert|refuse|approximate|note|known|FileError|comment)\s*$")
NOT_PICTURE = re.compile(r"gamma<|\bbound|\bspread|\berror|\bnote\(|witness|\bclipped\b|std::uint64_t|isfinite|"
                         r"\b(typical|diagonal)\b")
DEFAULT_VALUE = re.compile(r"(?:^\s*(?:[\w:<>]+\s+)+\w+\s*(?:=\s*|\{)|[(,]\s*[\w:]+\s+\w+\s*=\s*)$")
GUARD = re.compile(r"[<>=!]=?\s*$")
NUMBER_IN_TEXT = re.compile(r"(?<![\w{.])\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w}])")


class Literal:
    def __init__(self, file, begin, old, new, line):
        self.file, self.begin, self.old, self.new, self.line = file, begin, old, new, line

    def __str__(self):
        return f"{self.file}:{self.line}: {self.old} -> {self.new}"


def changed_number(text, suffix=""):
    digits = text[:len(text) - len(suffix)]
    if digits.lower().startswith("0x"):
        return hex(int(digits, 16) + 1) + suffix
    if re.fullmatch(r"\d+", digits):
        return str(int(digits) + 1) + suffix
    value = float(digits)
    return repr(value * 1.25 if value else 1.0) + suffix


def changed_text(text):
    if text.lstrip('" ').startswith("//"):
        return None
    found = NUMBER_IN_TEXT.search(text)
    if found:
        return text[:found.start()] + changed_number(found.group()) + text[found.end():]
    word = re.search(r"(?<![{\\\w])[A-Za-z_]{2,}", text)
    return text[:word.end()] + "x" + text[word.end():] if word else None


def message_spans(source):
    """Where the arguments of calls lie whose texts only people read."""
    spans = []
    for call in re.finditer(r"\(", source):
        if not MESSAGE.search(source, max(0, call.start() - 40), call.start()):
            continue
        depth, at = 0, call.start()
        while at < len(source):
            depth += {"(": 1, ")": -1}.get(source[at], 0)
            at += 1
            if depth == 0:
                break
        spans.append((call.start(), at))
    return spans


def literals(file):
    source = (ROOT / file).read_text()
    messages = message_spans(source)
    for token in TOKEN.finditer(source):
        if any(begin <= token.start() < end for begin, end in messages):
            continue
        begin = source.rfind("\n", 0, token.start()) + 1
        before, line = source[begin:token.start()], source[begin:source.find("\n", begin)]
        if token.group("text") is None and (NOT_PICTURE.search(line) or DEFAULT_VALUE.search(before)):
            continue
        if token.group("text") and re.search(r'"[^"]*//', before):
            continue
        if token.group("number") == "0" and GUARD.search(before):
            continue
        old = token.group()
        new = None
        if token.group("number"):
            new = changed_number(old, token.group("suffix"))
        elif token.group("word") in ("true", "false"):
            new = "false" if old == "true" else "true"
        elif token.group("text") and file.startswith("reference/"):
            new = changed_text(old)
        if new:
            yield Literal(file, token.start(), old, new, source.count("\n", 0, token.start()) + 1)


def all_literals():
    files = sorted({str(path.relative_to(ROOT)) for pattern in WRITER + SHADER for path in ROOT.glob(pattern)
                    if path.stem not in TALKERS})
    return [literal for file in files for literal in literals(file)]


def run(command, folder, limit):
    """The exit code, 'timeout' where it took longer than `limit` seconds."""
    try:
        return subprocess.run(command, cwd=folder, timeout=limit, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, errors="replace")
    except subprocess.TimeoutExpired:
        return None


class Laboratory:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        for part in ("CMakeLists.txt", "cmake", "model", "parser", "tracer", "reference", "cli", "scenes"):
            source = ROOT / part
            if source.is_dir():
                shutil.copytree(source, self.folder / part, dirs_exist_ok=True)
            else:
                shutil.copy2(source, self.folder / part)
        done = run(["cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None", "-DBUILD_TESTING=OFF",
                    "-DCMAKE_CXX_FLAGS=-O1"], self.folder, 300)
        if done is None or done.returncode != 0:
            raise SystemExit(done.stdout if done else "cmake hangs")

    def builds(self):
        done = run(["cmake", "--build", "build"], self.folder, 3600)
        return done is not None and done.returncode == 0

    def objection(self):
        """The first words of a scene's failure, '' where all scenes validate."""
        for part in SCENES:
            scenes = sorted(str(p.relative_to(self.folder)) for p in (self.folder / "scenes" / part).glob("*.lancer"))
            if not scenes:
                continue
            done = run(["build/bin/lancer", "validate", *scenes], self.folder, 900)
            if done is None:
                return f"{part}: does not end"
            if done.returncode != 0:
                bad = [line for line in done.stdout.splitlines()
                       if not re.search(r"\b(agrees|refused)\b|^scene ", line) and line.strip()]
                return f"{part}: {bad[0][:100] if bad else 'exit ' + str(done.returncode)}"
        return ""

    def examine(self, literal):
        """What validate says of the sources with this literal changed; None where they do not compile."""
        path = self.folder / literal.file
        original = path.read_text()
        end = literal.begin + len(literal.old)
        path.write_text(original[:literal.begin] + literal.new + original[end:])
        try:
            return self.objection() if self.builds() else None
        finally:
            path.write_text(original)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--count", type=int, default=30)
    options.add_argument("--folder", help="where to build; a temporary folder by default")
    options.add_argument("--list", action="store_true", help="print every literal with its change, and stop")
    options = options.parse_args()

    found = all_literals()
    if options.list:
        print(*found, sep="\n")
        return 0
    random.Random(options.seed).shuffle(found)
    folder = options.folder or tempfile.mkdtemp(prefix="lancer-mutation-")
    laboratory = Laboratory(folder)
    if not laboratory.builds() or (words := laboratory.objection()):
        raise SystemExit(f"the unchanged sources do not pass: {words if laboratory.builds() else 'no build'}")
    print(f"{len(found)} literals; the unchanged sources pass", flush=True)

    noticed, missed, uncompiled = 0, [], 0
    for literal in found:
        if noticed + len(missed) == options.count:
            break
        start = time.monotonic()
        words = laboratory.examine(literal)
        seconds = f"{time.monotonic() - start:4.0f} s"
        if words is None:
            uncompiled += 1
            print(f"  no build {seconds}  {literal}", flush=True)
        elif words:
            noticed += 1
            print(f"  noticed  {seconds}  {literal}   [{words}]", flush=True)
        else:
            missed.append(literal)
            print(f"  MISSED   {seconds}  {literal}", flush=True)
    print(f"noticed {noticed} of {noticed + len(missed)}; {uncompiled} more did not compile")
    if not options.folder:
        shutil.rmtree(folder)
    return 0 if noticed >= options.count - 1 else 1


sys.exit(main())
