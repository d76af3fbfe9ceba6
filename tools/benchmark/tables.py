"""Rows of measurements -> tables with a last line that says how everything grows with the faces."""

import math


class Column:
    """One of a table's columns.

    `value(row)` and `growing(row)` give numbers; None, or KeyError for what was not measured, is an
    empty cell. `growing` is the time (or memory, bytes) of which the exponent is shown; without it
    the column has none.
    """

    def __init__(self, heading, value, growing=None):
        self.heading = heading
        self.value = empty_if_missing(value)
        self.growing = empty_if_missing(growing or (lambda row: None))


def empty_if_missing(of):
    def value(row):
        try:
            return of(row)
        except KeyError:
            return None
    return value


def exponent(faces, values):
    """e of values ~ faces^e by least squares of the logarithms; None where there are no two sizes."""
    if len(set(faces)) < 2:
        return None
    x = [math.log(f) for f in faces]
    y = [math.log(v) for v in values]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    spread = sum((one - mean_x) ** 2 for one in x)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / spread


def number(value, digits=3):
    """Three digits that count, thousands set apart; counts in full."""
    if value is None:
        return ""
    if value >= 100 or value == int(value):
        return f"{value:,.0f}"
    return f"{value:.{max(0, digits - 1 - math.floor(math.log10(value)))}f}"


def growth(rows, column):
    measured = [(row["faces"], column.growing(row)) for row in rows]
    measured = [(faces, value) for faces, value in measured if value]
    e = exponent([faces for faces, _ in measured], [value for _, value in measured])
    return "" if e is None else f"^{e:.2f}"


def print_table(rows, columns):
    """Columns without any value are left out."""
    columns = [c for c in columns if any(c.value(row) is not None for row in rows)]
    lines = [["model"] + [column.heading for column in columns]]
    for row in rows:
        lines.append([row["name"]] + [number(column.value(row)) for column in columns])
    if len(rows) > 1:
        lines.append(["growth"] + [growth(rows, column) for column in columns])
    align(lines)


def align(lines):
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    for line in lines:
        cells = [line[0].ljust(widths[0])] + [c.rjust(w) for c, w in zip(line[1:], widths[1:])]
        print("  ".join(cells).rstrip())
