"""Knobs that cut what a ray does: depth, contribution, tolerance. What is left out, at the same points of the pixels, and what
it saves: rays, or of tolerance time."""
import measured
import plots

SIZE = ("--size", "96x72", "--samples", "2", "--sampling", "sobol")
GLASS = ["gallery/mirror_hall", "gallery/globe", "gallery/chess", "gallery/still_life", "glass/refraction", "glass/prism",
         "glass/fresnel_glass", "glass/coloured_shadows"]
CURVED = ["gallery/teapot", "shapes/patch_bezier", "shapes/patch_bspline"]
DEPTHS = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64]
CONTRIBUTIONS = ["0.1", "0.03", "0.01", "0.003", "0.001", "0.0001", "0.00001"]
TOLERANCES = ["0.1", "0.03", "0.01", "0.003", "0.001", "0.0003"]


def short(scene):
    return scene.split("/")[1]


def rays(stats):
    return sum(stats["rays"].values())


def swept(lancer, scenes, values, options_of):
    """{scene: [(value, share of the rays, rmse)]} beside the same points without the limit."""
    found = {}
    for scene in scenes:
        full = rays(lancer.render(scene, "whole.exr", [*SIZE, *measured.UNCUT]))
        found[scene] = []
        for value in values:
            left = rays(lancer.render(scene, "cut.exr", [*SIZE, *options_of(value)]))
            found[scene].append((value, left / full, lancer.rmse("cut.exr", "whole.exr")))
        print(scene, flush=True)
    return found


def percent(share):
    return f"{100 * share:.0f} %"


def depth(lancer, rounds):
    del rounds  # rays are counted
    found = swept(lancer, GLASS, DEPTHS, lambda d: ["--max-depth", str(d), "--min-contribution", "1e-12"])
    rows = [[short(scene), *(f"{error:.1g}, {percent(share)}" for _, share, error in cells)] for scene, cells in found.items()]
    plot = plots.lines("What a limit of the depth leaves out", "--max-depth", "RMSE",
                       {short(s): [(d, e) for d, _, e in rows] for s, rows in found.items()})
    return measured.table(["RMSE, rays: depth", *map(str, DEPTHS)], rows), {"study_depth.svg": plot}


def contribution(lancer, rounds):
    """What is really lost, and what `--bound-cut` proves."""
    del rounds  # rays are counted
    found = swept(lancer, GLASS, CONTRIBUTIONS, lambda x: ["--max-depth", "1000", "--min-contribution", x])
    rows, curves = [], {}
    for scene, losses in found.items():
        cells = []
        for value, share, error in losses:
            stats = lancer.render(scene, "cut.exr", [*SIZE, "--max-depth", "1000", "--min-contribution", value, "--bound-cut"])
            cells.append(f"{error:.1g} ≤ {stats['cut']['rmse']:.1g}, {percent(share)}")
        rows.append([short(scene), *cells])
        curves[short(scene)] = [(float(x), e) for x, _, e in losses]
    plot = plots.lines("What a least contribution leaves out", "--min-contribution", "RMSE", curves)
    return measured.table(["RMSE ≤ bound, rays", *CONTRIBUTIONS], rows), {"study_contribution.svg": plot}


def tolerance(lancer, rounds):
    rows, curves = [], {}
    for scene in CURVED:
        exact = lancer.seconds(scene, "true.exr", SIZE, rounds)
        cells = []
        for value in TOLERANCES:
            seconds = lancer.seconds(scene, "cut.exr", [*SIZE, "--tolerance", value], rounds)
            cells.append((float(value), lancer.rmse("cut.exr", "true.exr"), seconds / exact))
        rows.append([short(scene), *(f"{error:.1g}, {percent(time)}" for _, error, time in cells)])
        curves[short(scene)] = [(value, error) for value, error, _ in cells]
        print(scene, flush=True)
    plot = plots.lines("Triangles in place of true surfaces", "--tolerance, in the scene's lengths", "RMSE", curves)
    return measured.table(["RMSE, time: tolerance", *TOLERANCES], rows), {"study_tolerance.svg": plot}
