"""A pack, a ray tracer that knows nothing but the pack, and what Lancer says of its picture: right, and wrong in some ways.
stranger_test.py LANCER"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parents[2]
SCENE = "tests/judge/stranger/still.lancer"
SIZE = ["--size", "64x48"]


def printed(page):
    """The commands of a page and what it shows of their output."""
    for block in re.findall(r"```\n(\$ .*?)```", page, re.DOTALL):
        for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
            command, _, output = part.partition("\n")
            yield command, output


def shape(text):
    """All but the digits, which differ by machine and time."""
    return [re.sub(r"[0-9]+(\.[0-9]+)?(e[-+][0-9]+)?", "#", " ".join(line.split())) for line in text.splitlines()]


def check_page(folder, lancer):
    """The page's commands print what it says, one after the other."""
    bin = folder / "bin"
    bin.mkdir()
    (bin / "lancer").symlink_to(lancer)
    (bin / "python3").symlink_to(sys.executable)
    path = f"{bin}:{os.environ['PATH']}"
    commands = list(printed((ROOT / "docs/reference-pack.md").read_text()))
    assert len(commands) >= 5, commands
    for command, output in commands:
        done = subprocess.run(["sh", "-c", command], cwd=folder, env={**os.environ, "PATH": path}, capture_output=True, text=True)
        assert shape(done.stdout + done.stderr) == shape(output), f"{command} prints\n{done.stdout}{done.stderr}"


def check_names(scene, readme):
    """Every name in the data stands in the page that defines them."""
    for name in re.findall(r'"([a-z_]+)":', json.dumps(scene)):
        assert re.search(rf"\b{name}\b", readme), f"'{name}' is not defined in the pack's README"


def main(lancer):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "tests").symlink_to(ROOT / "tests")

        def run(*arguments, code=0):
            done = subprocess.run([str(a) for a in arguments], cwd=folder, capture_output=True, text=True)
            assert done.returncode == code, f"{arguments}: {done.returncode}\n{done.stdout}{done.stderr}"
            return done.stdout + done.stderr

        run(lancer, "pack", SCENE, *SIZE, "-o", "pack")
        assert json.loads((folder / "pack/pack.json").read_text())["scenes"] == ["still"]
        readme = (folder / "pack/README.md").read_text()
        assert "Right-handed" in readme
        check_names(json.loads((folder / "pack/still/scene.json").read_text()), readme)
        said = run(sys.executable, HERE / "stranger.py", "pack/still", "still.png")
        assert "probes agree" in said and int(said.split()[0]) >= 20, said
        assert "agrees" in run(lancer, "validate", SCENE, "--against", "still.png")

        # Typical mistakes in other renderers, and the expected messages.
        source = (HERE / "stranger.py").read_text()
        for right, wrong, cause in [("(j + 0.5)", "(j + 0.0)", "--pixel-center 0.5,0"),
                                    ('dot(n, to) > 0 and', 'dot(n, to) > 0 or', None),
                                    ('strength = lamp["color"]', 'strength = times(lamp["color"], 0.99)', "is 0.99 times as bright"),
                                    ("** lamp[\"fade\"][\"power\"]", "** 1.0", "light 2")]:
            assert source.count(right) == 1, right
            (folder / "wrong.py").write_text(source.replace(right, wrong).replace("assert ", "True or "))
            run(sys.executable, "wrong.py", "pack/still", "wrong.png")
            said = run(lancer, "validate", SCENE, "--against", "wrong.png", code=1)
            assert "differs" in said
            assert cause is None or f"likely cause: " in said and cause in said, said

        check_page(folder, lancer)

        # A pack may replace a pack, and nothing else.
        run(lancer, "pack", SCENE, *SIZE, "-o", "pack", "-q")
        (folder / "mine").mkdir()
        (folder / "mine/diary.txt").write_text("dear diary")
        assert "not an earlier pack" in run(lancer, "pack", SCENE, "-o", "mine", code=2)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
