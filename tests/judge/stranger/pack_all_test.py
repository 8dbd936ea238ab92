"""Every scene of the collection in one pack; and a pack that goes on past scenes that are wrong.
pack_all_test.py LANCER"""
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).parents[3]


def scenes():
    found = sorted((ROOT / "scenes").rglob("*.lancer"))
    return [scene for scene in found if scene.relative_to(ROOT / "scenes").parts[0] != "bad"]


def read_pfm(path):
    """Width, height and floats, rows from the top."""
    with open(path, "rb") as file:
        channels = {b"PF\n": 3, b"Pf\n": 1}[file.readline()]
        width, height = map(int, file.readline().split())
        assert file.readline() == b"-1.0\n"
        data = file.read()
    assert len(data) == 4 * channels * width * height, path
    row = channels * width
    values = struct.unpack(f"<{row * height}f", data)
    return [values[row * j:row * (j + 1)] for j in reversed(range(height))], channels


def check(folder, readme):
    """The data name what is defined and files that are there; pictures and probes say the same."""
    scene = json.loads((folder / "scene.json").read_text())
    names = set(re.findall(r'"([A-Za-z_]+)":', json.dumps(scene)))
    unknown = [name for name in names if not re.search(rf"\b{name}\b", readme)]
    assert not unknown, f"{folder.name}: {unknown} are not defined in the pack's README"
    for file in re.findall(r'"file": "([^"]+)"', json.dumps(scene)):
        assert (folder / file).stat().st_size > 0, file
    for thing in scene["objects"]:
        assert re.fullmatch(r".*:[0-9]+:[0-9]+", thing["place"]), thing
        if thing["kind"] == "mesh":
            has_normals = "\nvn " in (folder / thing["file"]).read_text()
            assert has_normals == thing["smooth"], f"{folder.name}/{thing['file']}: what is smooth needs normals"
    picture, channels = read_pfm(folder / "color.pfm")
    bound = scene["pictures"]["color"]
    assert channels == 3 and len(picture) == scene["height"] and len(picture[0]) == 3 * scene["width"]
    for probe in scene["probes"]:
        for c in range(3):
            seen = picture[probe["y"]][3 * probe["x"] + c]
            off = abs(seen - probe["color"][c])
            assert off <= bound["error"] + probe["color_error"][c] + 1.01 * bound["relative_error"] * abs(seen) + 1e-45, \
                f"{folder.name}: {probe} but {seen}"
    objects, depths, normals = (read_pfm(folder / f"{name}.pfm")[0] for name in ("object", "depth", "normal"))
    for probe in scene["probes"]:
        x, y, nothing = probe["x"], probe["y"], probe["object"] is None
        assert objects[y][x] == (-1 if nothing else probe["object"]), f"{folder.name}: {probe} but object {objects[y][x]}"
        assert math.isclose(depths[y][x], 0 if nothing else probe["depth"], rel_tol=1e-6), f"{folder.name}: {probe}"
        for c in range(3):
            assert abs(normals[y][3 * x + c] - (0 if nothing else probe["normal"][c])) < 1e-6, f"{folder.name}: {probe}"
    return len(scene["probes"])


def main(lancer):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def run(*arguments, code):
            done = subprocess.run([lancer, "pack", *arguments, "-o", folder / "pack"], cwd=folder, capture_output=True, text=True)
            assert done.returncode == code, f"{done.returncode}\n{done.stdout}{done.stderr}"
            return done.stdout + done.stderr

        said = run(*scenes(), "--size", "48x36", code=0)
        packed = json.loads((folder / "pack/pack.json").read_text())["scenes"]
        assert len(packed) == len(scenes()) > 100 and f"{len(packed)} scenes, " in said, said[-500:]
        assert "this surface has a tolerance; the pack holds the true surface" in said
        readme = (folder / "pack/README.md").read_text()
        compared = subprocess.run([lancer, "compare", "--fail", "0", *2 * ["pack/ten_lines/color.pfm"]], cwd=folder, capture_output=True)
        assert compared.returncode == 0, compared.stderr
        probes = sum(check(folder / "pack" / scene, readme) for scene in packed)
        assert probes > 20 * len(packed), probes

        # Invalid and missing scenes, and one without a camera, between two valid ones.
        (folder / "wrong.lancer").write_text("sphere { radius }")
        (folder / "blind.lancer").write_text("sphere { radius 1 }")
        right = scenes()[0], scenes()[-1]
        said = run(right[0], "wrong.lancer", "nowhere.lancer", "blind.lancer", right[1], "--size", "48x36", code=4)
        assert "3 of 5 scenes were left out: wrong.lancer, nowhere.lancer, blind.lancer" in said, said
        assert "wrong.lancer:1:17: error" in said, said
        assert len(json.loads((folder / "pack/pack.json").read_text())["scenes"]) == 2
        said = run(right[0], "wrong.lancer", "--size", "48x36", code=3)
        assert "1 of 2 scenes were left out: wrong.lancer" in said, said


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
