#!/usr/bin/python3
"""Draws pairs of the high and the low tank, left and right at random, for a person to guess which is which.

Usage: scripts/model/blind.py [--distance METRES] [--seed N] [--scale N] [--out FOLDER]    draws the pairs
       scripts/model/blind.py --out FOLDER --guess LRLR...                                 counts the right ones

From twelve sides and three heights, on the ground and with shadow, as in a window of 1280 x 800; a guess says for each
pair where the high one is. The answers lie beside the pictures: look at those first.
"""

import argparse
import json
import pathlib
import random
import subprocess
import tempfile

import numpy
from PIL import Image, ImageDraw

from pairs import HEIGHT, ROOT, WIDTH, shipped_threshold

HEADINGS = range(0, 360, 30)
TILTS = (3, 12, 28)
HALF_WIDTH, HALF_HEIGHT = 40, 26  # of a crop, pixels
COLUMNS = 3


def picture(build, folder, fields):
    path = pathlib.Path(folder) / "view.png"
    link = "#" + "&".join(f"{name}={value}" for name, value in fields.items())
    command = [build / "tanklab-render", link, "--size", f"{WIDTH}x{HEIGHT}", "--out", path]
    subprocess.run([*command, "--assets", ROOT / "assets"], check=True, stdout=subprocess.DEVNULL)
    middle = (WIDTH // 2, HEIGHT // 2)
    box = (middle[0] - HALF_WIDTH, middle[1] - HALF_HEIGHT, middle[0] + HALF_WIDTH, middle[1] + HALF_HEIGHT)
    return Image.open(path).convert("RGB").crop(box)


def draw(arguments):
    order = random.Random(arguments.seed)
    views = [(heading, tilt) for heading in HEADINGS for tilt in TILTS]
    order.shuffle(views)
    answers, cells = "", []
    with tempfile.TemporaryDirectory() as folder:
        for heading, tilt in views:
            fields = dict(heading=heading, tilt=tilt, orbit=0, distance=arguments.distance, look_x=0, look_y=1.4, look_z=0)
            pair = [picture(arguments.build, folder, {**fields, "detail": level}) for level in ("high", "low")]
            answers += order.choice("LR")  # where the high one is
            cells.append(pair if answers[-1] == "L" else pair[::-1])
    size = (2 * HALF_WIDTH * arguments.scale, 2 * HALF_HEIGHT * arguments.scale)
    step = (2 * size[0] + 30, size[1] + 16)
    rows = -(-len(cells) // COLUMNS)
    sheet = Image.new("RGB", (COLUMNS * step[0], rows * step[1]), "white")
    pen = ImageDraw.Draw(sheet)
    for i, pair in enumerate(cells):
        x, y = i % COLUMNS * step[0], i // COLUMNS * step[1]
        pen.text((x, y + 2), str(i + 1), "black")
        for side, crop in enumerate(pair):
            sheet.paste(crop.resize(size, Image.NEAREST), (x + 16 + side * (size[0] + 4), y + 12))
    arguments.out.mkdir(parents=True, exist_ok=True)
    half = rows // 2 * step[1]
    sheet.crop((0, 0, sheet.width, half)).save(arguments.out / "blind-1.png")
    sheet.crop((0, half, sheet.width, sheet.height)).save(arguments.out / "blind-2.png")
    (arguments.out / "answers.json").write_text(json.dumps({"answers": answers, "views": views}))


def count(arguments):
    answers = json.loads((arguments.out / "answers.json").read_text())["answers"]
    right = sum(a == b for a, b in zip(answers, arguments.guess))
    print(f"{right} of {len(arguments.guess)} right")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/native")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build/blind")
    parser.add_argument("--distance", type=float, default=shipped_threshold())
    parser.add_argument("--seed", type=int)
    parser.add_argument("--scale", type=int, default=1)
    parser.add_argument("--guess")
    arguments = parser.parse_args()
    (count if arguments.guess else draw)(arguments)


if __name__ == "__main__":
    main()
