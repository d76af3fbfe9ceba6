"""Line drawings of classical octrees: figures 5 to 8 and 10 to 12 of Veenstra and Ahuja, Line
Drawings of Octree-Represented Objects, ACM TOG 7(1), 1988."""

import csv
import json
import math

# Of each drawing: the model, its size, and where it is seen from.
DRAWINGS = {
    "classical-5-cylinder": ("cylinder", (128,), "0.55,-0.71,0.44"),
    "classical-6-cone": ("cone", (128,), "0.55,-0.71,0.44"),
    "classical-7-sphere": ("sphere", (64,), "0.55,-0.71,0.44"),
    "classical-8-pyramid": ("pyramid", (), "0.55,-0.71,0.44"),
    "classical-10-self-occluding": ("self-occluding", (64,), "0.55,-0.71,0.6"),
    "classical-11-diamond": ("diamond", (), "1,-0.5,0.2"),
}

DRAWN_DEPTH = 6
TABLE_DEPTHS = range(4, 9)

# A cell is counted as the paper's digital silhouettes were: by what its middle is.
PARTIAL = "half"

STAGES = ("rebuild", "line-scene", "draw")


def build(workshop, drawing, depth):
    name, size, _ = DRAWINGS[drawing]
    spo = workshop.scratch / f"{name}-{depth}.spo"
    workshop.run("spoctree-server", "build", workshop.model(name, *size), "-o", spo,
                 "--kind", "classical", "--max-depth", depth, "--partial", PARTIAL)
    return spo


def drawing_of(drawing):
    def draw(workshop):
        spo = build(workshop, drawing, DRAWN_DEPTH)
        for ending in ("svg", "png"):
            workshop.run("spoctree-client", "draw", spo, "--from", DRAWINGS[drawing][2],
                         "-o", workshop.output / f"{drawing}.{ending}")

    number, what = drawing.split("-", 2)[1:]
    draw.__doc__ = f"Figure {number}: the classical octree of a {what}, drawn (svg, png)"
    return draw


def measure(workshop, spo):
    """Nodes of a tree, and CPU ms of each stage of drawing it, by one thread."""
    said = workshop.run("spoctree-benchmark", "--benchmark_format=json", spo)
    row = {"drawing_ms": 0.0}
    for one in json.loads(said)["benchmarks"]:
        stage = one["name"].split("/")[0].removeprefix("tree-")
        row[f"{stage}_ms"] = one["cpu_time"]
        row["drawing_ms"] += one["cpu_time"]
        row |= {key: int(one[key]) for key in ("nodes", "full_leaves", "graphics_nodes")}
        if stage == "draw":
            row["lines"] = int(one["made"])
    return row


def growth(rows, of, by="graphics_nodes"):
    """The exponent e of time ~ nodes^e: least squares of the logarithms."""
    x = [math.log(row[by]) for row in rows]
    y = [math.log(row[of]) for row in rows]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return (sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y))
            / sum((a - mean_x) ** 2 for a in x))


COLUMNS = ("object", "depth", "nodes", "full_leaves", "graphics_nodes", "lines",
           *(f"{stage}_ms" for stage in STAGES), "drawing_ms", "us_per_graphics_node")


def figure_12(workshop):
    """Figure 12: nodes, full leaves, graphics nodes and drawing time, depths 4 to 8 (csv, txt)

    The paper's graphics nodes are the full octants that have a neighbour that is not full. Its time
    grew with their square; the last lines of the table say with which power ours does. Times are
    CPU ms of one thread, from the tree to its visible lines: the boundary (`rebuild`), the pieces
    and creases (`line-scene`, once per tree), and the view (`draw`)."""
    rows = []
    for drawing in DRAWINGS:
        for depth in TABLE_DEPTHS:
            row = measure(workshop, build(workshop, drawing, depth))
            row |= {"object": DRAWINGS[drawing][0], "depth": depth}
            row["us_per_graphics_node"] = 1000 * row["drawing_ms"] / row["graphics_nodes"]
            rows.append(row)
    with open(workshop.output / "classical-12.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows({column: row[column] for column in COLUMNS} for row in rows)
    text = "  ".join(f"{column:>15}" for column in COLUMNS) + "\n"
    for row in rows:
        cells = (f"{row[c]:.2f}" if isinstance(row[c], float) else str(row[c]) for c in COLUMNS)
        text += "  ".join(f"{cell:>15}" for cell in cells) + "\n"
    text += "\ntime ~ graphics nodes^e (the paper's: 2)\n"
    for name in dict.fromkeys(row["object"] for row in rows):
        of_object = [row for row in rows if row["object"] == name]
        powers = ", ".join(f"{stage} {growth(of_object, f'{stage}_ms'):.2f}" for stage in STAGES)
        text += f"{name:>15}  {growth(of_object, 'drawing_ms'):.2f}  ({powers})\n"
    text += f"{'all':>15}  {growth(rows, 'drawing_ms'):.2f}\n"
    (workshop.output / "classical-12.txt").write_text(text)
    print(text, end="")


FIGURES = {drawing: drawing_of(drawing) for drawing in DRAWINGS} | {"classical-12": figure_12}
