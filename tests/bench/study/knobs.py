"""Which knob buys most where: `lancer tradeoff` over the gallery, its knobs put together."""
import json
import subprocess

import measured
import plots

SIZE = "96x72"
ERRORS = [0.02, 0.01, 0.005]


def measure(lancer, scene, budget):
    file = lancer.folder / "tradeoff.json"
    subprocess.run([lancer.program, "tradeoff", measured.ROOT / "scenes" / "gallery" / f"{scene}.lancer", "--size", SIZE, "--threads", "1",
                    "--json", file, "--quiet", "--budget", str(budget)], check=True, capture_output=True)
    return json.loads(file.read_text())["scenes"][0]


def study(lancer, rounds):
    found = {scene: measure(lancer, scene, 20 * rounds) for scene in measured.GALLERY}
    gains, rows = {}, []
    for scene, page in found.items():
        exact = page["settings"][page["exact"]]["seconds"]
        for setting in page["settings"]:
            gains.setdefault(setting["label"], []).append((exact / setting["seconds"], setting["rmse"]))
        cells = [scene]
        for asked in ERRORS:
            enough = [s for s in page["settings"] if s["rmse"] <= asked]
            best = min(enough, key=lambda s: s["seconds"], default=None)
            cells.append(f"{best['label']}: {exact / best['seconds']:.2g}" if best else "none")
        rows.append(cells)
        print(scene, flush=True)
    everywhere = {label: g for label, g in gains.items() if len(g) == len(found)}
    by_knob = [[label, f"{measured.mean([g for g, _ in pairs]):.2g}", f"{measured.mean([e for _, e in pairs]):.2g}", f"{max(e for _, e in pairs):.2g}"]
               for label, pairs in sorted(everywhere.items(), key=lambda item: -measured.mean([g for g, _ in item[1]]))]
    curve = {scene: sorted((s["seconds"] / page["settings"][page["exact"]]["seconds"], s["rmse"]) for s in page["settings"] if s["frontier"])
             for scene, page in found.items()}
    text = (measured.table(["setting", "times as fast as exact", "RMSE", "worst scene's"], by_knob) + "\nThe cheapest setting for an error, "
            "and how many times as fast as `exact` it is:\n\n" + measured.table(["scene", *(f"{e:g}" for e in ERRORS)], rows))
    return text, {"study_knobs.svg": plots.lines("Settings that nothing beats", "time, as a share of exact", "RMSE", curve)}
