#!/usr/bin/python3
"""Draws the high and the low tank at a distance, magnified side by side, and prints how their colours differ.

Usage: scripts/model/pairs.py [--build FOLDER] [--distance METRES] [--out FILE] [--scale N] [--part PART]
                               [--every N]

Takes build/native/tanklab-render. From eight sides, two heights, and with the sun from two sides, as in a window of
1280 x 800: for each view the mean colour of either tank's pixels, and the largest difference of a channel.
"""

import argparse
import math
import pathlib
import re
import subprocess
import tempfile

import numpy
from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
WIDTH, HEIGHT = 1280, 800


def shipped_threshold():
    text = (ROOT / "src/app/state/fields.cpp").read_text()
    return int(re.search(r"DEFAULT_THRESHOLD = ([\d']+)", text)[1].replace("'", "")) / 1000


def views():
    for heading in (0, 180):
        for tilt in (3, 25):
            for orbit in range(0, 360, 45):
                yield heading, tilt, orbit + heading


def aside(orbit):
    """The same way to look, but past the tank."""
    angle = math.radians(orbit)
    return f"look_x={20 * math.cos(angle):.3f}&look_z={-20 * math.sin(angle):.3f}&look_y=1.4"


class Renderer:
    def __init__(self, build, distance, part, folder):
        self.build, self.distance, self.part, self.folder = build, distance, part, folder

    def picture(self, view, level, look):
        heading, tilt, orbit = view
        path = pathlib.Path(self.folder) / "view.png"
        fields = (f"heading={heading}&tilt={tilt}&orbit={orbit}&distance={self.distance}&detail={level}", look)
        link = "#" + "&".join(fields) + f"&ground=off&parts={self.part}"
        command = [self.build / "tanklab-render", link, "--size", f"{WIDTH}x{HEIGHT}", "--out", path]
        subprocess.run([*command, "--assets", ROOT / "assets"], check=True, stdout=subprocess.DEVNULL)
        half = (int(13000 / self.distance), int(8000 / self.distance))
        middle = (WIDTH // 2, HEIGHT // 2)
        box = (middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1])
        return numpy.array(Image.open(path).convert("RGB").crop(box)).astype(int)


def compared(renderer, view):
    """Returns the pictures of a view, the mean colours of the two tanks' pixels and how many either has."""
    here = "look_x=0&look_z=0&look_y=1.4"
    none = renderer.picture(view, "high", aside(view[2]))
    pictures = [renderer.picture(view, level, here) for level in ("high", "low")]
    masks = [(abs(picture - none) > 2).any(2) for picture in pictures]
    means = [picture[mask].mean(0) for picture, mask in zip(pictures, masks)]
    return pictures, means, [int(mask.sum()) for mask in masks]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/native")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build/pairs.png")
    parser.add_argument("--distance", type=float, default=shipped_threshold())
    parser.add_argument("--scale", type=int, default=6)
    parser.add_argument("--part", default="all")
    parser.add_argument("--every", type=int, default=1, help="take only each of so many views")
    arguments = parser.parse_args()
    rows, worst, all_off = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        renderer = Renderer(arguments.build, arguments.distance, arguments.part, folder)
        for view in list(views())[:: arguments.every]:
            pictures, (high, low), counts = compared(renderer, view)
            off = low - high
            all_off.append(off)
            worst.append(abs(off).max())
            text = " ".join(f"{channel:6.1f}" for channel in (*high, *low, *off))
            print("heading %3d tilt %2d orbit %3d: %s  pixels %d %d" % (*view, text, *counts))
            rows.append(numpy.concatenate(pictures, 1))
    print("largest difference of a channel: mean %.1f, worst %.1f" % (numpy.mean(worst), max(worst)))
    print("mean difference: %s" % numpy.round(numpy.mean(all_off, 0), 1))
    columns = 4
    rows += [numpy.full_like(rows[0], 255)] * (-len(rows) % columns)
    lines = [numpy.concatenate(rows[i : i + columns], 1) for i in range(0, len(rows), columns)]
    sheet = Image.fromarray(numpy.concatenate(lines, 0).astype(numpy.uint8))
    sheet.resize((sheet.width * arguments.scale, sheet.height * arguments.scale), Image.NEAREST).save(arguments.out)
    print(arguments.out)


if __name__ == "__main__":
    main()
