"""The table of drawing: views, and OpenCASCADE's two algorithms beside the first of them."""

from tables import Column, print_table


def cpu_ms(part):
    return lambda row: row["parts"][part]["cpu_time"]


def ratio(part, to="draw"):
    return lambda row: cpu_ms(part)(row) / cpu_ms(to)(row)


COLUMNS = (
    Column("faces", lambda row: row["faces"]),
    Column("lines", lambda row: row["parts"]["draw"]["lines"]),
    Column("rebuild ms", cpu_ms("rebuild"), cpu_ms("rebuild")),
    Column("pieces ms", cpu_ms("line-scene"), cpu_ms("line-scene")),
    Column("draw ms", cpu_ms("draw"), cpu_ms("draw")),
    Column("front ms", cpu_ms("draw-front"), cpu_ms("draw-front")),
    Column("front/draw", ratio("draw-front")),
    Column("front/near it", ratio("draw-front", to="draw-near-front")),
    Column("perspective ms", cpu_ms("draw-perspective"), cpu_ms("draw-perspective")),
    Column("hidden ms", cpu_ms("draw-behind-plate"), cpu_ms("draw-behind-plate")),
    Column("hidden/draw", ratio("draw-behind-plate")),
    Column("OCCT poly ms", cpu_ms("draw-occt-poly"), cpu_ms("draw-occt-poly")),
    Column("poly/draw", ratio("draw-occt-poly")),
    Column("OCCT exact ms", cpu_ms("draw-occt-exact"), cpu_ms("draw-occt-exact")),
    Column("exact/draw", ratio("draw-occt-exact")),
    Column("OCCT lines", lambda row: row["parts"]["draw-occt-poly"]["lines"]),
)


def show(rows):
    print_table(rows, COLUMNS)
