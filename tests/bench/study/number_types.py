"""The number type: time, and what the pictures differ by from extended precision at the same points."""
import measured

SIZE = ("--size", "160x120", "--samples", "2", "--sampling", "sobol")
TYPES = ["single", "double", "extended"]


def study(lancer, rounds):
    rows, times = [], {kind: [] for kind in TYPES}
    for scene in measured.GALLERY:
        name = f"gallery/{scene}"
        seconds = {k: lancer.seconds(name, f"{k}.exr", [*SIZE, "--precision", k], rounds) for k in TYPES}
        cells = [scene]
        for kind in TYPES:
            times[kind].append(seconds[kind] / seconds["double"])
            cells.append(f"{times[kind][-1]:.2f}")
        for kind in ("single", "double"):
            apart = lancer.compared(f"{kind}.exr", "extended.exr")
            cells.append(f"{apart['rmse']:.1g}, {apart['max']:.1g}")
        rows.append(cells)
        print(name, flush=True)
    rows.append(["mean", *(f"{measured.mean(times[k]):.2f}" for k in TYPES), "", ""])
    return measured.table(["scene", *(f"{k}: time" for k in TYPES), "single: RMSE, largest", "double: RMSE, largest"], rows), {}
