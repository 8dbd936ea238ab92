#!/usr/bin/env python3
"""FLIP computed a second time, for flip_test.cpp to be compared with.

Written from the paper (Andersson et al. 2020) with none of the shortcuts of reference/compare/flip.cpp:
two-dimensional kernels, one plain sum per pixel, the matrix inverted by elimination. Prints the
errors of a few pixels of the pictures below; the output is kept in flip_expected.txt.
Needs Python 3 and nothing else.
"""
import math

CASES = [("noise", 67.020643276582256), ("noise", 30.0), ("edge", 67.020643276582256), ("edge", 30.0)]
WIDTH, HEIGHT = 17, 13
PROBES = [(0, 0), (8, 6), (16, 12), (3, 9), (12, 2), (9, 6), (7, 0)]


def picture(case, test):
    """Rows of linear RGB; flip_test.cpp has the same formulas."""
    rows = []
    for y in range(HEIGHT):
        row = []
        for x in range(WIDTH):
            if case == "noise":
                seed = 7 * x + 3 * y + (5 if test else 0)
                row.append([(seed % 11) / 10, (seed * 5 % 13) / 12, (seed * 3 % 7) / 6])
            else:
                bright = x + (1 if test else 0) > 8
                row.append([0.8, 0.6, 0.1 + y / 20] if bright else [0.05, 0.1, 0.3])
        rows.append(row)
    return rows


# The matrix from the chromaticities of sRGB's primaries and of its white, D65 with five digits.
def invert(m):
    n = len(m)
    a = [list(map(float, m[i])) + [1.0 if i == j else 0.0 for j in range(n)] for i in range(n)]
    for i in range(n):
        p = max(range(i, n), key=lambda r: abs(a[r][i]))
        a[i], a[p] = a[p], a[i]
        a[i] = [v / a[i][i] for v in a[i]]
        for r in range(n):
            if r != i:
                a[r] = [v - a[r][i] * w for v, w in zip(a[r], a[i])]
    return [row[n:] for row in a]


def times(m, v):
    return [sum(row[i] * v[i] for i in range(3)) for row in m]


def xyz_of(x, y):
    return [x / y, 1.0, (1 - x - y) / y]


PRIMARIES = [xyz_of(0.64, 0.33), xyz_of(0.30, 0.60), xyz_of(0.15, 0.06)]
WHITE = xyz_of(0.31271, 0.32902)
COLUMNS = [[PRIMARIES[j][i] for j in range(3)] for i in range(3)]
SCALES = times(invert(COLUMNS), WHITE)
TO_XYZ = [[COLUMNS[i][j] * SCALES[j] for j in range(3)] for i in range(3)]
FROM_XYZ = invert(TO_XYZ)


def relative(rgb):
    return [v / w for v, w in zip(times(TO_XYZ, rgb), WHITE)]


def ycxcz(rgb):
    x, y, z = relative(rgb)
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)]


def rgb_of_ycxcz(c):
    y = (c[0] + 16) / 116
    return times(FROM_XYZ, [v * w for v, w in zip([y + c[1] / 500, y, y - c[2] / 200], WHITE)])


def lab(rgb):
    def f(t):
        return t ** (1 / 3) if t > (6 / 29) ** 3 else t / (3 * (6 / 29) ** 2) + 4 / 29

    x, y, z = (f(v) for v in relative(rgb))
    lightness = 116 * y - 16
    return [lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)]


def hyab(a, b):
    return abs(a[0] - b[0]) + math.hypot(a[1] - b[1], a[2] - b[2])


def at(plane, x, y):
    return plane[min(max(y, 0), HEIGHT - 1)][min(max(x, 0), WIDTH - 1)]


def correlate(plane, kernel, x, y):
    r = len(kernel) // 2
    return sum(kernel[j + r][i + r] * at(plane, x + i, y + j)
               for j in range(-r, r + 1) for i in range(-r, r + 1))


def csf_kernel(ppd, a1, b1, a2, b2):
    r = math.ceil(3 * math.sqrt(0.04 / (2 * math.pi ** 2)) * ppd)

    def weight(i, j):
        d2 = (i * i + j * j) / (ppd * ppd)
        return (a1 * math.sqrt(math.pi / b1) * math.exp(-math.pi ** 2 * d2 / b1)
                + a2 * math.sqrt(math.pi / b2) * math.exp(-math.pi ** 2 * d2 / b2))

    k = [[weight(i, j) for i in range(-r, r + 1)] for j in range(-r, r + 1)]
    total = sum(map(sum, k))
    return [[v / total for v in row] for row in k]


def feature_kernels(ppd):
    s = 0.5 * 0.082 * ppd
    r = math.ceil(3 * s)

    def kernel(f):
        k = [[f(i, j) * math.exp(-(i * i + j * j) / (2 * s * s)) for i in range(-r, r + 1)]
             for j in range(-r, r + 1)]
        plus = sum(v for row in k for v in row if v > 0)
        minus = -sum(v for row in k for v in row if v < 0)
        return [[v / plus if v > 0 else v / minus for v in row] for row in k]

    return (kernel(lambda i, j: -i), kernel(lambda i, j: -j),
            kernel(lambda i, j: i * i / (s * s) - 1), kernel(lambda i, j: j * j / (s * s) - 1))


def flip(case, ppd, x, y):
    sensitivities = [csf_kernel(ppd, 1, 0.0047, 0, 1e-5), csf_kernel(ppd, 1, 0.0053, 0, 1e-5),
                     csf_kernel(ppd, 34.1, 0.04, 13.5, 0.025)]
    kernels = feature_kernels(ppd)
    seen, edges, points = [], [], []
    for test in (False, True):
        opponent = [[ycxcz(c) for c in row] for row in picture(case, test)]
        planes = [[[c[k] for c in row] for row in opponent] for k in range(3)]
        filtered = [correlate(planes[k], sensitivities[k], x, y) for k in range(3)]
        seen.append(lab([min(max(v, 0), 1) for v in rgb_of_ycxcz(filtered)]))
        grey = [[(v + 16) / 116 for v in row] for row in planes[0]]
        response = [correlate(grey, k, x, y) for k in kernels]
        edges.append(math.hypot(response[0], response[1]))
        points.append(math.hypot(response[2], response[3]))
    largest = hyab(lab([0, 1, 0]), lab([0, 0, 1])) ** 0.7
    e = hyab(seen[0], seen[1]) ** 0.7
    knee = 0.4 * largest
    color = 0.95 / knee * e if e < knee else 0.95 + (e - knee) / (largest - knee) * 0.05
    feature = max(abs(edges[0] - edges[1]), abs(points[0] - points[1]))
    return color ** (1 - min(1, (feature / math.sqrt(2)) ** 0.5))


if __name__ == "__main__":
    print("# case pixels_per_degree x y error; written by flip_check.py")
    for case, ppd in CASES:
        for x, y in PROBES:
            print(case, repr(ppd), x, y, "%.12f" % flip(case, ppd, x, y))
