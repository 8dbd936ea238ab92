"""Plots as SVG, both axes logarithmic, readable in light and dark."""
import math

COLORS = ["#1f77b4", "#d95f02", "#2ca02c", "#c23b8f", "#8a6d3b", "#7b5fc0", "#c0392b", "#138d90"]
STYLE = ("<style>text{font:13px sans-serif;fill:#444}.title{font-weight:bold}.frame{fill:none;stroke:#888}"
         ".grid{stroke:#8883}@media (prefers-color-scheme:dark){text{fill:#ccc}}</style>")
LEFT, TOP, WIDTH, HEIGHT = 62, 30, 430, 250


def tick(value):
    return f"{value:g}" if 1e-3 <= value < 1e5 else f"{value:.0e}".replace("e-0", "e-").replace("e+0", "e")


class Axis:
    def __init__(self, values, begin, end):
        low, high = min(values), max(values)
        self.low, self.high = math.log10(low) - 0.05, math.log10(high) + 0.05
        self.begin, self.end = begin, end

    def at(self, value):
        return self.begin + (self.end - self.begin) * (math.log10(value) - self.low) / (self.high - self.low)

    def ticks(self):
        powers = range(math.ceil(self.low), math.floor(self.high) + 1)
        if len(powers) >= 2:
            step = math.ceil(len(powers) / 8)
            return [10.0 ** p for p in powers if p % step == 0]
        return [m * 10.0 ** p for p in range(math.floor(self.low), math.ceil(self.high) + 1) for m in (1, 2, 5)
                if self.low <= math.log10(m * 10.0 ** p) <= self.high]


def lines(title, across, upwards, series):
    """`series`: {name: [(x, y)]}, at most eight. Points of y = 0 have no place and are left out."""
    series = {name: [(x, y) for x, y in points if y > 0] for name, points in series.items()}
    series = {name: points for name, points in series.items() if points}
    every = [p for points in series.values() for p in points]
    x = Axis([p[0] for p in every], LEFT, LEFT + WIDTH)
    y = Axis([p[1] for p in every], TOP + HEIGHT, TOP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 690 {TOP + HEIGHT + 48}" role="img">', f"<title>{title}</title>", STYLE,
           f'<text class="title" x="{LEFT}" y="18">{title}</text>',
           f'<rect class="frame" x="{LEFT}" y="{TOP}" width="{WIDTH}" height="{HEIGHT}"/>']
    for value in x.ticks():
        out += [f'<path class="grid" d="M{x.at(value):.1f} {TOP}v{HEIGHT}"/>',
                f'<text x="{x.at(value):.1f}" y="{TOP + HEIGHT + 18}" text-anchor="middle">{tick(value)}</text>']
    for value in y.ticks():
        out += [f'<path class="grid" d="M{LEFT} {y.at(value):.1f}h{WIDTH}"/>',
                f'<text x="{LEFT - 6}" y="{y.at(value) + 4:.1f}" text-anchor="end">{tick(value)}</text>']
    out.append(f'<text x="{LEFT + WIDTH / 2}" y="{TOP + HEIGHT + 38}" text-anchor="middle">{across}</text>')
    out.append(f'<text transform="rotate(-90)" x="{-(TOP + HEIGHT / 2)}" y="13" text-anchor="middle">{upwards}</text>')
    for i, (name, points) in enumerate(series.items()):
        color = COLORS[i % len(COLORS)]
        path = " ".join(f"{x.at(a):.1f},{y.at(b):.1f}" for a, b in points)
        out.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="2"/>')
        out += [f'<circle cx="{x.at(a):.1f}" cy="{y.at(b):.1f}" r="3" fill="{color}"><title>{name}: {tick(a)}, {b:.3g}</title></circle>'
                for a, b in points]
        down = TOP + 14 + 20 * i
        out += [f'<path d="M{LEFT + WIDTH + 14} {down - 4}h18" stroke="{color}" stroke-width="3"/>',
                f'<text x="{LEFT + WIDTH + 38}" y="{down}">{name}</text>']
    return "\n".join([*out, "</svg>"]) + "\n"


def bars(title, across, groups):
    """`groups`: {name: [(label, value)]}, values from 0 to 100; the labels are the same in all."""
    thick, gap, left = 9, 9, 96
    labels = [label for label, _ in next(iter(groups.values()))]
    row = thick * len(labels) + gap
    bottom = TOP + 24 + row * len(groups)
    def at(value):
        return left + WIDTH * min(value, 100) / 100
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {left + WIDTH + 50} {bottom + 40}" role="img">', f"<title>{title}</title>", STYLE,
           f'<text class="title" x="{left}" y="18">{title}</text>']
    for i, label in enumerate(labels):
        out += [f'<path d="M{left + 150 * i} 35h18" stroke="{COLORS[i]}" stroke-width="{thick}"/>',
                f'<text x="{left + 150 * i + 24}" y="39">{label}</text>']
    for value in range(0, 101, 20):
        out += [f'<path class="grid" d="M{at(value):.1f} {TOP + 20}V{bottom}"/>',
                f'<text x="{at(value):.1f}" y="{bottom + 16}" text-anchor="middle">{value}</text>']
    for k, (name, values) in enumerate(groups.items()):
        top = TOP + 24 + row * k
        out.append(f'<text x="{left - 8}" y="{top + row / 2:.1f}" text-anchor="end">{name}</text>')
        for i, (label, value) in enumerate(values):
            out.append(f'<rect x="{left}" y="{top + thick * i}" width="{at(value) - left:.1f}" height="{thick - 1}" fill="{COLORS[i]}">'
                       f"<title>{name}, {label}: {value:.0f} %</title></rect>")
    out.append(f'<text x="{left + WIDTH / 2}" y="{bottom + 34}" text-anchor="middle">{across}</text>')
    return "\n".join([*out, "</svg>"]) + "\n"


def intervals(title, groups):
    """`groups`: {name: [(low, high)]}, intervals as shares of the truth, which is 1. Those that miss it are red."""
    panel, height, most = 132, 200, 1.5
    width = panel * len(groups) + 50
    def at(value):
        return TOP + 20 + height * (1 - (min(max(value, 2 - most), most) - (2 - most)) / (2 * most - 2))
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {TOP + height + 50}" role="img">', f"<title>{title}</title>", STYLE,
           f'<text class="title" x="40" y="18">{title}</text>']
    for value in (0.5, 0.75, 1, 1.25, 1.5):
        out.append(f'<text x="36" y="{at(value) + 4:.1f}" text-anchor="end">{value:g}</text>')
    for i, (name, rows) in enumerate(groups.items()):
        left = 42 + panel * i
        held = sum(low <= 1 <= high for low, high in rows)
        out += [f'<rect class="frame" x="{left}" y="{TOP + 20}" width="{panel - 8}" height="{height}"/>',
                f'<path d="M{left} {at(1):.1f}h{panel - 8}" stroke="#888"/>',
                f'<text x="{left + panel / 2 - 4}" y="{TOP + height + 40}" text-anchor="middle">{name}: {held} of {len(rows)}</text>']
        for k, (low, high) in enumerate(sorted(rows, key=lambda r: r[0] + r[1])):
            x = left + 3 + (panel - 14) * k / max(1, len(rows) - 1)
            color = "#1f77b4" if low <= 1 <= high else "#e03c31"
            out.append(f'<path d="M{x:.1f} {at(low):.1f}V{at(high):.1f}" stroke="{color}" stroke-width="1.2"/>')
    return "\n".join([*out, "</svg>"]) + "\n"
