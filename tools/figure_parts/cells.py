"""Cells and avenues of sight: figures 2 and 8 to 14 of Jones, A new approach to the 'hidden line'
problem, Computer Journal 14(3), 1971, and what this method costs beside the one from front to
back."""

import csv
import os
import sys
from pathlib import Path

# Of each drawing: what it shows, the model, the eye, the target, the width of the picture in
# degrees.
DRAWINGS = {
    "cells-2-house-plan": ("the house from its living room", "house-plan",
                           "3600,700,1700", "6100,3000,1500", 76),
    "cells-2-kitchen": ("the house from its kitchen, through the hatch", "house-plan",
                        "7600,7200,1700", "7300,3000,1300", 84),
    "cells-8-court": ("the court from its corner", "city-block",
                      "21000,22000,1700", "35000,35500,8500", 84),
    "cells-9-roofs": ("the court from above a roof", "city-block",
                      "15000,29000,30000", "34000,33000,8000", 75),
    "cells-10-pillar": ("the court from the corner beyond its pillar", "city-block",
                        "39000,38500,1700", "24500,26000,7500", 84),
    "cells-11-archway": ("the street through the archway", "city-block",
                         "25500,36000,1700", "48000,36000,3500", 60),
    "cells-12-tower": ("the block from outside", "city-block",
                       "-24000,-30000,42000", "30000,30000,6000", 60),
    "cells-13-far-side": ("the block from its far side", "city-block",
                          "-45000,130000,52000", "30000,30000,6000", 40),
}

# As figure 14, two eyes beside each other.
STEREO = "cells-8-court"

MODELS = ("house-plan", "city-block")
MESHES = (
    "polygons/3torus_quads_23f.off",
    "polygons/hole_quads_28f.off",
    "multi/eryone-er20_792f.stl",
    "high-genus/helmet_1000f.off",
    "cad/anchor_1050f.off",
    "cad/spool_1294f.off",
    "nested/y-belt-tensioner_5cavities_2366f.stl",
    "scan/stanford-bunny-filled_3996f.off",
    "nested/openscad-projection_cavity_4160f.stl",
    "high-genus/cheese_17786f.off",
)


def draw(workshop, drawing, name, *options):
    _, model, eye, target, fov = DRAWINGS[drawing]
    spo = workshop.scratch / f"{model}.spo"
    if not spo.exists():
        workshop.run("spoctree-server", "build", workshop.model(model), "-o", spo)
    for ending in ("svg", "png"):
        workshop.run("spoctree-client", "draw", spo, "--method", "cells", f"--eye={eye}",
                     f"--target={target}", "--fov", fov, *options,
                     "-o", workshop.output / f"{name}.{ending}")


def drawing_of(drawing):
    def make(workshop):
        draw(workshop, drawing, drawing)

    make.__doc__ = f"Figure {drawing.split('-')[1]}: {DRAWINGS[drawing][0]} (svg, png)"
    return make


def figure_14(workshop):
    """Figure 14: a stereo pair of the court (svg, png)"""
    draw(workshop, STEREO, "cells-14-stereo", "--stereo")


COLUMNS = {
    "model": "model",
    "faces": "faces",
    "view": "view",
    "lines": "lines",
    "only_front_to_back": "only f.t.b.",
    "only_cells": "only cells",
    "cells": "cells",
    "openings": "openings",
    "avenues": "avenues",
    "front_prepare_s": "f.t.b.: prepare s",
    "front_draw_s": "draw s",
    "cells_prepare_s": "cells: prepare s",
    "cells_draw_s": "draw s",
}


def comparison(workshop):
    """Both methods: differences, time, numbers of cells, openings and avenues (csv, txt)

    Of the paper's two objects and of ten solids of the folder SPOCTREE_MESHES, if it is set.
    Lengths that only one method draws are fractions of the universe cube's diagonal; preparing is
    once per level, drawing once per view."""
    folder = os.environ.get("SPOCTREE_MESHES", "")
    if not folder:
        print("figures: SPOCTREE_MESHES is not set: only generated models are compared",
              file=sys.stderr)
    sources = [*MODELS, *(Path(folder) / mesh for mesh in MESHES if folder)]
    table = workshop.output / "cells-comparison.csv"
    workshop.run("compare_methods", "--csv", table, *sources)
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    widths = {key: max(len(title), *(len(row[key]) for row in rows))
              for key, title in COLUMNS.items()}
    text = "  ".join(f"{title:>{widths[key]}}" for key, title in COLUMNS.items()) + "\n"
    for row in rows:
        text += "  ".join(f"{row[key]:>{widths[key]}}" for key in COLUMNS) + "\n"
    (workshop.output / "cells-comparison.txt").write_text(text)
    print(text, end="")


FIGURES = {drawing: drawing_of(drawing) for drawing in DRAWINGS} | {
    "cells-14-stereo": figure_14, "cells-comparison": comparison}
