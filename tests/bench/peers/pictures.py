"""How far apart two pictures are: PPM with 16 bits of linear light, in plain Python."""
import array
import math
import sys


def read(path):
    """Width, height, and the values row by row, three for each pixel."""
    with open(path, "rb") as file:
        lines = (line for line in iter(file.readline, b"") if not line.startswith(b"#"))
        magic, size, most = next(lines), next(lines), next(lines)
        if magic != b"P6\n" or most != b"65535\n":
            raise RuntimeError(f"{path} is no PPM of 16 bits")
        width, height = map(int, size.split())
        values = array.array("H", file.read())
    if sys.byteorder == "little":
        values.byteswap()
    return width, height, values


def block_means(picture, block):
    """The mean of each block of block x block pixels, one list for each channel and row of blocks."""
    width, height, values = picture
    means = []
    for y in range(0, height - block + 1, block):
        rows = [values[(y + i) * width * 3:(y + i + 1) * width * 3] for i in range(block)]
        for channel in range(3):
            columns = [sum(column) for column in zip(*(row[channel::3] for row in rows))]
            means.append([sum(columns[x:x + block]) / (block * block * 65535)
                          for x in range(0, width - block + 1, block)])
    return means


def rmse(a, block_a, b, block_b):
    """Root of the mean squared difference of the means of blocks."""
    pairs = [(p, q) for row_a, row_b in zip(block_means(read(a), block_a), block_means(read(b), block_b))
             for p, q in zip(row_a, row_b)]
    return math.sqrt(sum((p - q) ** 2 for p, q in pairs) / len(pairs))
