#!/usr/bin/python3
"""Draws the assembled tank as Tank Lab draws it, from many sides, in extreme poses and from close by, on one sheet.

Usage: scripts/model/sheet.py [--build FOLDER] [--out FILE] [--size WxH] [--columns N] [VIEW ...]

Takes build/native/tanklab-render. Without names all views; with one, that picture alone in full size.
"""

import argparse
import pathlib
import subprocess
import tempfile

from PIL import Image, ImageDraw

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def look(x, y, z, distance, orbit, tilt, *pose):
    """The link of a view: the eye turned about (x, y, z), angles in degrees."""
    view = f"look_x={x}&look_y={y}&look_z={z}&distance={distance}&orbit={orbit}&tilt={tilt}"
    return "#" + "&".join((view, "detail=high", *pose))


VIEWS = {
    "front left": look(0, 1.3, 0.9, 9, 40, 15),
    "front": look(0, 1.4, 1.0, 9, 3, 10),
    "front right": look(0, 1.3, 0.9, 9, -40, 15),
    "right": look(0, 1.3, 1.0, 9, -90, 6),
    "rear right": look(0, 1.4, 0.5, 8.5, -140, 18),
    "rear": look(0, 1.5, -0.5, 8, 180, 12),
    "rear left": look(0, 1.4, 0.5, 8.5, 140, 18),
    "left": look(0, 1.3, 1.0, 9, 90, 6),
    "above": look(0, 1.0, 0.8, 12, 25, 75),
    "gun up": look(0, 1.8, 0.8, 11, 60, 8, "gun=20", "secondary_gun=-60", "secondary_gun_pitch=60"),
    "gun down": look(0, 1.3, 0.8, 11, 60, 8, "gun=-9", "secondary_gun=60", "secondary_gun_pitch=-10"),
    "turret turned": look(0, 1.2, 0, 11, 50, 20, "turret=95", "gun=20"),
    "turret back": look(0, 1.2, -1, 11, 145, 14, "turret=180", "gun=-4"),
    "turret": look(0.3, 2.1, 0.6, 5.0, 45, 20),
    "cheek right": look(-0.3, 2.1, 0.8, 4.5, -50, 12),
    "roof": look(0, 2.4, -0.2, 4.5, -30, 48),
    "bustle": look(0.1, 2.0, -1.6, 4.6, 150, 25),
    "smoke": look(1.2, 2.0, 0.2, 4.0, 80, 10),
    "mantlet": look(0, 2.0, 1.7, 4.0, 35, 8, "gun=20"),
    "gun": look(0, 2.0, 4.4, 5.2, 70, 10),
    "muzzle": look(0, 2.0, 5.6, 4.0, 20, 6),
    "machine gun": look(-0.55, 2.75, 0.1, 4.0, -50, 14),
    "machine gun up": look(-0.55, 2.85, 0.1, 4.0, -70, 5, "secondary_gun_pitch=60"),
    "machine gun down": look(-0.55, 2.75, 0.1, 4.0, 60, 10, "secondary_gun_pitch=-10", "secondary_gun=20"),
    "machine gun left": look(-0.3, 2.75, -0.1, 4.0, 20, 20, "secondary_gun_pitch=-10", "secondary_gun=90"),
    "machine gun back": look(-0.5, 2.75, -0.3, 4.0, 170, 20, "secondary_gun_pitch=60", "secondary_gun=120"),
    "running gear": look(1.6, 0.6, 0.6, 4.2, 75, 2),
    "wheel": look(1.6, 0.45, 1.6, 4.0, 62, 0),
    "idler": look(1.4, 0.7, 3.1, 4.0, 40, 3),
    "sprocket": look(1.4, 0.8, -3.1, 4.0, 130, 6),
    "glacis": look(0, 1.2, 2.8, 5.0, 15, 25, "turret=60"),
    "rear plate": look(0.3, 1.2, -3.6, 4.6, 165, 8),
    "engine deck": look(0, 1.6, -2.6, 4.6, 160, 40, "turret=120"),
    "ring": look(0.6, 1.7, 0.4, 4.0, 60, 3, "turret=40"),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/native")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "build/tank_sheet.png")
    parser.add_argument("--size", default="960x600")
    parser.add_argument("--columns", type=int, default=3)
    parser.add_argument("views", nargs="*", metavar="VIEW", choices=[[], *VIEWS])
    arguments = parser.parse_args()
    names = arguments.views or list(VIEWS)
    pictures = []
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            path = pathlib.Path(folder) / "view.png"
            subprocess.run(
                [
                    arguments.build / "tanklab-render",
                    VIEWS[name],
                    "--size",
                    arguments.size,
                    "--out",
                    path,
                    "--assets",
                    ROOT / "assets",
                ],
                check=True,
                stdout=subprocess.DEVNULL,
            )
            pictures.append(Image.open(path).convert("RGB"))
            ImageDraw.Draw(pictures[-1]).text((8, 6), name, fill="black")
    columns = min(arguments.columns, len(names))
    width, height = pictures[0].size
    sheet = Image.new("RGB", (columns * width, -(-len(names) // columns) * height), "white")
    for index, picture in enumerate(pictures):
        sheet.paste(picture, (index % columns * width, index // columns * height))
    sheet.save(arguments.out)
    print(arguments.out)


if __name__ == "__main__":
    main()
