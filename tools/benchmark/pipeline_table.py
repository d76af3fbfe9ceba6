"""The table of building, sending, rebuilding and asking, and the bytes of each level."""

from tables import Column, align, print_table


def wall_ms(part):
    return lambda row: row["parts"][part]["real_time"]


def rate(row, part):
    return row["parts"][part]["items_per_second"]


def build(key):
    return lambda row: row["build"][key]


def draco(key):
    return lambda row: row["draco"][key]


COLUMNS = (
    Column("faces", lambda row: row["faces"]),
    Column("build faces/s", lambda row: row["faces"] / row["build"]["wall"], build("wall")),
    Column("wall s", build("wall"), build("wall")),
    Column("CPU s", build("cpu"), build("cpu")),
    Column("peak MB", lambda row: row["build"]["peak"] / 1e6, build("peak")),
    Column("stream bytes", build("bytes"), build("bytes")),
    Column("decode ms", wall_ms("decode"), wall_ms("decode")),
    Column("rebuild ms", wall_ms("rebuild"), wall_ms("rebuild")),
    Column("both ms", wall_ms("decode+rebuild"), wall_ms("decode+rebuild")),
    Column("classify k/s", lambda row: rate(row, "classify") / 1e3,
           lambda row: 1 / rate(row, "classify")),
    Column("x CGAL side", lambda row: rate(row, "classify") / rate(row, "classify-cgal")),
    Column("rays k/s", lambda row: rate(row, "ray") / 1e3, lambda row: 1 / rate(row, "ray")),
    Column("x CGAL AABB", lambda row: rate(row, "ray") / rate(row, "ray-cgal")),
    Column("draco s", draco("wall"), draco("wall")),
    Column("draco bytes", draco("bytes"), draco("bytes")),
)


def show(rows):
    print_table(rows, COLUMNS)
    print("\nstream bytes per level")
    sizes = [row["build"]["bytes_per_level"] for row in rows]
    lines = [["level"] + [row["name"] for row in rows]]
    for level in range(max(map(len, sizes))):
        lines.append([str(level)] + [f"{of[level]:,}" if level < len(of) else "" for of in sizes])
    align(lines)
