#!/usr/bin/env python3
"""pages_test.py PAGES: the manual pages and completions, in the programs that read them.

PAGES is the folder that make_pages has filled. Exit code 77, skipped, where a program is missing, which CI has.
"""
import glob
import os
import pty
import select
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

pages = os.path.abspath(sys.argv.pop(1))
commands = "render join check info export compare pack validate stability tradeoff probe".split()
for program in ("man", "bash", "zsh", "fish"):
    if not shutil.which(program):
        print(f"skipped: there is no {program} (cmake/packages.sh)")
        sys.exit(77)


class Shell:
    """A shell at a terminal of its own, in which `lancer` is a stand-in that prints its words: <render><<"""

    def __init__(self, argv, setup, folder):
        self.child, self.terminal = pty.fork()
        if self.child == 0:
            os.chdir(folder)
            os.environ.update(TERM="dumb", HOME=folder, HISTFILE="/dev/null", LANG="C.UTF-8")
            os.execvp(argv[0], argv)
        setup += "; lancer() { printf '<%s>' \"$@\"; printf '<<'; }"
        # The terminal echoes what is typed; the typed text does not contain the word itself.
        self.type(f"{setup}; echo set''up\n", "setup\r")

    def type(self, text, mark="<<"):
        """What is shown until the mark comes."""
        os.write(self.terminal, text.encode())
        shown, end = "", time.monotonic() + 30
        while mark not in shown and time.monotonic() < end:
            if select.select([self.terminal], [], [], 0.05)[0]:
                try:
                    shown += os.read(self.terminal, 65536).decode(errors="replace")
                except OSError:
                    break
        return shown

    def close(self):
        os.kill(self.child, 9)
        os.waitpid(self.child, 0)
        os.close(self.terminal)


class Pages(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory(prefix="lancer-pages-")
        self.folder = self.place.name
        for name in ("room.lancer", "notes.txt", "room.png"):
            open(os.path.join(self.folder, name), "w").close()
        os.mkdir(os.path.join(self.folder, "reports"))

    def tearDown(self):
        self.place.cleanup()

    def test_the_manual_renders_without_warnings(self):
        manuals = sorted(glob.glob(pages + "/man/*.1"))
        self.assertEqual(len(manuals), 1 + len(commands))
        for manual in manuals:
            environment = dict(os.environ, LANG="C.UTF-8", LC_ALL="C.UTF-8", MANWIDTH="80", MAN_KEEP_FORMATTING="")
            done = subprocess.run(["man", "--warnings=w", "-l", manual], capture_output=True, text=True,
                                  env=environment, stdin=subprocess.DEVNULL)
            self.assertEqual((done.returncode, done.stderr), (0, ""), manual)
            lines = done.stdout.splitlines()
            self.assertGreater(len(lines), 30, manual)
            self.assertEqual([line for line in lines if len(line) > 80], [], manual)
            for title in ("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"):
                self.assertIn(title, lines, manual)

    # Each case: the typed text, and the resulting words of the command.
    completed = [
        ("lancer ren\t", ["render"]),
        ("lancer render --qual\t", ["render", "--quality"]),
        ("lancer render --quality dr\t", ["render", "--quality", "draft"]),
        ("lancer check ro\t", ["check", "room.lancer"]),
        ("lancer validate --report rep\t", ["validate", "--report", "reports/"]),
        ("lancer compare room.p\t", ["compare", "room.png"]),
    ]

    def try_in_shell(self, argv, setup, also=()):
        shell = Shell(argv, setup, self.folder)
        self.addCleanup(shell.close)
        for text, words in [*self.completed, *also]:
            with self.subTest(shell=argv[0], typed=text):
                # At the end of the line, zsh removes the slash of a folder again.
                expected = "".join(f"<{word.rstrip('/')}>" for word in words) + "<<"
                self.assertIn(expected, shell.type(text + "\n").replace("/>", ">"))

    def test_bash_completes(self):
        self.try_in_shell(["bash", "--norc", "--noprofile", "-i"], f"source '{pages}/bash/lancer'",
                          [("lancer render --quality=fi\t", ["render", "--quality=fine"])])

    def test_zsh_completes(self):
        self.try_in_shell(["zsh", "-f", "-i"], f"fpath=('{pages}/zsh' $fpath); autoload -U compinit; compinit -D -u",
                          [("lancer render --quality=fi\t", ["render", "--quality=fine"])])

    def test_fish_completes(self):
        for text, words in self.completed:
            line = text.rstrip("\t")
            done = subprocess.run(
                ["fish", "--no-config", "-c", f"source '{pages}/fish/lancer.fish'; complete -C '{line}'"],
                capture_output=True, text=True, cwd=self.folder, env=dict(os.environ, HOME=self.folder))
            self.assertEqual(done.stderr, "")
            offered = [row.split("\t")[0] for row in done.stdout.splitlines()]
            self.assertIn(words[-1], offered, line)

    def test_fish_knows_what_a_command_takes(self):
        done = subprocess.run(
            ["fish", "--no-config", "-c", f"source '{pages}/fish/lancer.fish'; complete -C 'lancer '"],
            capture_output=True, text=True, cwd=self.folder, env=dict(os.environ, HOME=self.folder))
        self.assertEqual(sorted(row.split("\t")[0] for row in done.stdout.splitlines()), sorted(commands))


if __name__ == "__main__":
    unittest.main()
