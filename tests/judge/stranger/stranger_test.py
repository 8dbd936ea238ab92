"""A pack, a ray tracer that knows nothing but the pack, and what Lancer says of its picture: right, and wrong in some ways.
stranger_test.py LANCER"""
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
SCENE = """
image { width 32 height 24 }
render { max_depth 4 }
background [0.1, 0.2, 0.35]
camera main { position [0.5, 2.4, 7] look_at [0, 0.6, 0] fov 40 }
light point { position [-4, 6, 5] color [0.6, 0.6, 0.5] }
light point { position [4, 5, 6] color [0.5, 0.5, 0.5] fade_distance 6 fade_power 2 }
plane { normal [0, 1, 0] offset -0.013 material { color texture { checker [[0.8, 0.8, 0.7], [0.2, 0.3, 0.3]] } } }
sphere { center [-1.3, 0.8, 0] radius 0.8 material { color [0.8, 0.3, 0.2] phong 0.4 shininess 20 } }
sphere { center [0.9, 0.7, 0.6] radius 0.7 material { color [0.2, 0.2, 0.3] reflection 0.5 } }
box { min [-0.4, 0, 1.4] max [0.3, 0.5, 2] material { color [0.3, 0.7, 0.4] } }
"""


def main(lancer):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "still.lancer").write_text(SCENE)

        def run(*arguments, code=0):
            done = subprocess.run([str(a) for a in arguments], cwd=folder, capture_output=True, text=True)
            assert done.returncode == code, f"{arguments}: {done.returncode}\n{done.stdout}{done.stderr}"
            return done.stdout + done.stderr

        run(lancer, "pack", "still.lancer", "-o", "pack")
        assert json.loads((folder / "pack/pack.json").read_text())["scenes"] == ["still"]
        assert "Right-handed" in (folder / "pack/README.md").read_text()
        said = run(sys.executable, HERE / "stranger.py", "pack/still", "still.png")
        assert "probes agree" in said and int(said.split()[0]) >= 20, said
        assert "agrees" in run(lancer, "validate", "still.lancer", "--against", "still.png")

        # Mistakes that strangers make, and what they are told.
        source = (HERE / "stranger.py").read_text()
        for right, wrong, cause in [("(j + 0.5)", "(j + 0.0)", "--pixel-center 0.5,0"),
                                    ('dot(n, to) > 0 and', 'dot(n, to) > 0 or', None),
                                    ('strength = lamp["color"]', 'strength = times(lamp["color"], 0.99)', "is 0.99 times as bright"),
                                    ("** lamp[\"fade\"][\"power\"]", "** 1.0", "light 2")]:
            assert source.count(right) == 1, right
            (folder / "wrong.py").write_text(source.replace(right, wrong).replace("assert ", "True or "))
            run(sys.executable, "wrong.py", "pack/still", "wrong.png")
            said = run(lancer, "validate", "still.lancer", "--against", "wrong.png", code=1)
            assert "differs" in said
            assert cause is None or f"likely cause: " in said and cause in said, said

        # A pack is written over a pack, and over nothing else.
        run(lancer, "pack", "still.lancer", "-o", "pack", "-q")
        (folder / "mine").mkdir()
        (folder / "mine/diary.txt").write_text("dear diary")
        assert "no pack" in run(lancer, "pack", "still.lancer", "-o", "mine", code=2)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
