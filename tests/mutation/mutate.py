#!/usr/bin/env python3
"""Would `lancer validate` notice a wrong number? Changes literals of the exporter and the shader, one at a time, and asks.

    tests/mutation/mutate.py [--seed 1 ...] [--count 30 | --all] [--only TEXT] [--folder DIR] [--list]

Draws `count` literals (literals.py says what one is, and which are left out) and validates the scenes with each of them
changed, until one fails. So that the program is built once and not once for each: in a copy of the sources every literal
stands beside its changed values, and LANCER_MUTANT in the environment chooses (mutant schemata: Untch, Offutt, Harrold,
"Mutation Analysis Using Mutant Schemata", ISSTA 1993). A first run of the unchanged program tells which scene looks at
which literal, so that only scenes are asked that can answer, the quickest first.

Exits with 1 when fewer than all but one in thirty are noticed.
"""
import argparse
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

from literals import OTHER_FILES, ROOT, RULES, all_literals

PARTS = ["CMakeLists.txt", "CMakePresets.json", "cmake", "model", "parser", "tracer", "reference", "cli", "scenes"]
PROGRAM = "build/dev/bin/lancer"
AT_ONCE = 2 * (os.cpu_count() or 1)  # scenes: POV-Ray sleeps while it starts

MOST = 4096  # literals
SWITCH = """// Which literal is changed, and which were looked at.
#pragma once
@PRAGMAS@
#ifndef FMT_CONSTEVAL
#define FMT_CONSTEVAL  // format strings are chosen at run time
#endif
#include <cstdio>
#include <cstdlib>
namespace mutant {
inline const int chosen = [] {
    const char* text = std::getenv("LANCER_MUTANT");
    return text != nullptr ? std::atoi(text) : -1;
}();
struct Seen {
    unsigned char at[@MOST@] = {};
    ~Seen() {
        const char* name = std::getenv("LANCER_SEEN");
        std::FILE* file = name != nullptr ? std::fopen(name, "w") : nullptr;
        if (file == nullptr) return;
        for (int i = 0; i < @MOST@; ++i) {
            if (at[i] != 0) std::fprintf(file, "%d\\n", i);
        }
        std::fclose(file);
    }
};
inline Seen seen;
inline bool is(int id) {
    seen.at[id] = 1;
    return chosen == id;
}
}  // namespace mutant
"""
# The copied judge stops once too many pixels are unexplained for the picture to pass: the verdict
# is the same.
JUDGE = "judge/explain/explain.cpp"
HURRY = [("    std::vector<Offset> offsets;\n    for (", "    std::vector<Offset> offsets;\n    std::size_t lost = 0;\n    for ("),
         ("if (result.rays >= most_rays) {", "if (result.rays >= most_rays || lost > limits.unexplained) {"),
         ("        result.classes[i] = pixel.pixel_class;\n",
          "        result.classes[i] = pixel.pixel_class;\n        lost += pixel.pixel_class == PixelClass::unexplained;\n")]
# `validate` renders in double, so the other two types need not be built.
IN_DOUBLE = """#include "tracer/render_types.h"

namespace lancer {

std::unique_ptr<Renderer> compile_@(const Scene& scene, const Settings& settings) {
    return compile_double(scene, settings);
}

}  // namespace lancer
"""
WARNINGS = ["narrowing", "conversion", "sign-conversion", "double-promotion", "parentheses", "extra", "sign-compare",
            "float-conversion", "array-bounds"]  # that a choice gives and a constant does not


def run(command, folder, limit, **variables):
    """What the command says and how it ends; None where it takes longer than `limit` seconds."""
    try:
        return subprocess.run(command, cwd=folder, timeout=limit, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, errors="replace", env={**os.environ, **variables})
    except subprocess.TimeoutExpired:
        return None


def write_if_new(path, text):
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


class Laboratory:
    def __init__(self, folder, literals):
        self.folder = pathlib.Path(folder).resolve()
        self.cache = {"LANCER_CACHE": str(self.folder / "cache")}
        self.copy_sources(literals)
        self.build()
        self.observe()

    def copy_sources(self, literals):
        by_file = {}
        for number, literal in enumerate(literals):
            by_file.setdefault(literal.file, []).append((number, literal))
        (self.folder / "tracer").mkdir(parents=True, exist_ok=True)
        for precision in ("single", "extended"):
            write_if_new(self.folder / f"tracer/render_{precision}.cpp", IN_DOUBLE.replace("@", precision))
        for part in PARTS:
            for source in [ROOT / part] if (ROOT / part).is_file() else (ROOT / part).rglob("*"):
                name = str(source.relative_to(ROOT))
                target = self.folder / name
                target.parent.mkdir(parents=True, exist_ok=True)
                if name in ("tracer/render_single.cpp", "tracer/render_extended.cpp"):
                    continue
                if name in by_file:
                    write_if_new(target, switched(source.read_text(), by_file[name]))
                elif name == JUDGE:
                    text = source.read_text()
                    for old, new in HURRY:
                        assert text.count(old) == 1, old
                        text = text.replace(old, new)
                    write_if_new(target, text)
                elif source.is_file() and not (target.exists() and target.read_bytes() == source.read_bytes()):
                    shutil.copy2(source, target)
        assert len(literals) <= MOST
        pragmas = "\n".join(f'#pragma GCC diagnostic ignored "-W{warning}"' for warning in WARNINGS)
        write_if_new(self.folder / "model" / "mutant.h",
                     SWITCH.replace("@MOST@", str(MOST)).replace("@PRAGMAS@", pragmas))

    def build(self):
        for command in (["cmake", "--preset", "dev", "-DBUILD_TESTING=OFF"],
                        ["cmake", "--build", "build/dev", "--target", "lancer"]):
            done = run(command, self.folder, 7200)
            if done is None or done.returncode != 0:
                raise SystemExit(done.stdout if done else f"{command} does not end")

    def observe(self):
        """Which scenes look at which literal, by the time that they take."""
        names = [str(path.relative_to(self.folder)) for path in (self.folder / "scenes").rglob("*.lancer")]

        def look(name):
            seen = self.folder / f"seen_{name.replace('/', '_')}"
            start = time.monotonic()
            done = run([PROGRAM, "validate", name], self.folder, 900, LANCER_SEEN=str(seen), **self.cache)
            if done is None or done.returncode != 0:
                raise SystemExit(f"the unchanged sources do not pass: {done.stdout if done else name}")
            looked_at = set(map(int, seen.read_text().split()))
            seen.unlink()
            return time.monotonic() - start, name, looked_at

        with ThreadPoolExecutor(AT_ONCE) as pool:
            self.scenes = sorted(pool.map(look, [name for name in names if not name.startswith("scenes/bad/")]))

    def objection(self, number):
        """The first words of a scene's failure, '' where all scenes agree that look at literal `number`."""
        waiting = [name for _, name, looked_at in self.scenes if number in looked_at]
        running = []
        words = ""
        while not words and (waiting or running):
            while waiting and len(running) < AT_ONCE:
                running.append(self.validation(waiting.pop(0), number))
            time.sleep(0.02)
            for process, said, end in running[:]:
                if process.poll() is None and time.monotonic() < end:
                    continue
                if process.returncode != 0:
                    words = failure(process, said)
                    break
                running.remove((process, said, end))
        for process, *_ in running:
            process.send_signal(signal.SIGINT)  # so that it takes POV-Ray and its folders along
            process.wait()
        return words

    def validation(self, name, number):
        """The process, the file with what it says, and when it is taken not to end."""
        said = tempfile.TemporaryFile("w+")
        process = subprocess.Popen([PROGRAM, "validate", name], cwd=self.folder, stdout=said, stderr=subprocess.STDOUT,
                                   env={**os.environ, "LANCER_MUTANT": str(number), **self.cache})
        return process, said, time.monotonic() + 900


def failure(process, said):
    if process.returncode is None:
        return "does not end"
    said.seek(0)
    bad = re.search(r"^\S+ +(differs|failed)\b.*", said.read(), re.MULTILINE)
    return re.sub(" +", " ", bad[0])[:60] if bad else f"exit {process.returncode}"


def switched(source, numbered):
    """The source with a choice in the place of each literal."""
    changes = {}
    for number, literal in numbered:
        changes.setdefault(literal.begin, (literal.old, []))[1].append(f"::mutant::is({number}) ? {literal.new} : ")
    for begin in sorted(changes, reverse=True):
        old, choices = changes[begin]
        source = f"{source[:begin]}({''.join(choices)}{old}){source[begin + len(old):]}"
    # A constant becomes a variable, but keeps its value everywhere.
    source = re.sub(r"\bconstexpr (Real|int|double|std::size_t)\b", r"const \1", source)
    return '#include "model/mutant.h"\n' + source


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--seed", type=int, nargs="+", default=[1])
    options.add_argument("--count", type=int, default=30)
    options.add_argument("--all", action="store_true", help="examine every literal")
    options.add_argument("--only", nargs="+", help="examine the literals whose line of --list holds one of these")
    options.add_argument("--folder", help="where to build; a temporary folder by default")
    options.add_argument("--list", action="store_true", help="print every literal with its change, and stop")
    options = options.parse_args()

    every = all_literals()
    literals = [literal for literal in every if literal.rule is None]
    if options.list:
        print(*literals, sep="\n")
        return 0
    print(f"{len(literals)} literals; left out {len(every) - len(literals)}:")
    for rule, reason in [*RULES.items(), *((f"{name}.*", OTHER_FILES[name]) for name in OTHER_FILES)]:
        print(f"  {sum(literal.rule == rule.removesuffix('.*') for literal in every):3d}  {rule}: {reason}")
    numbered = list(enumerate(literals))
    if options.all:
        draws = {"": numbered}
    elif options.only:
        draws = {"": [(number, literal) for number, literal in numbered
                      if any(text in str(literal) for text in options.only)]}
    else:
        draws = {f"seed {seed}: ": random.Random(seed).sample(numbered, options.count) for seed in options.seed}

    folder = options.folder or tempfile.mkdtemp(prefix="lancer-mutation-")
    laboratory = Laboratory(folder, literals)
    print(f"the unchanged sources pass {len(laboratory.scenes)} scenes", flush=True)
    enough = True
    for name, drawn in draws.items():
        missed = 0
        for number, literal in drawn:
            start = time.monotonic()
            words = laboratory.objection(number)
            missed += not words
            print(f"  {'noticed' if words else 'MISSED '} {time.monotonic() - start:5.1f} s  {literal}" +
                  (f"   [{words}]" if words else ""), flush=True)
        print(f"{name}noticed {len(drawn) - missed} of {len(drawn)}", flush=True)
        enough = enough and 30 * missed <= len(drawn)
    if not options.folder:
        shutil.rmtree(folder)
    return 0 if enough else 1


if __name__ == "__main__":
    sys.exit(main())
