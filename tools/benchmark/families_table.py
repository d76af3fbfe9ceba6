"""The table of building models of several kinds, each in four sizes, beside scans."""

import math
import subprocess
import sys

import families
import measure
from tables import align, exponent, number


def build_one(mesh, folder, repeat, options=()):
    command = [measure.SERVER, "build", mesh, "-o", folder / "model.spo", "--threads", "1", *options]
    return measure.best_of(repeat, command)


def measure_families(folder, scans, repeat):
    """Rows of family, faces, CPU seconds and peak; scans are (faces, mesh)."""
    rows = []
    for faces, mesh in scans:
        rows.append({"family": "scan", "faces": faces} | build_one(mesh, folder, repeat))
    mesh = folder / "family.stl"
    for name, _, sizes, options in families.FAMILIES:
        for size in sizes:
            # In a process of its own: a program's peak is no less than that of what starts it.
            made = subprocess.run([sys.executable, families.__file__, name, str(size), mesh],
                                  check=True, capture_output=True, text=True)
            rows.append({"family": name, "faces": int(made.stdout)}
                        | build_one(mesh, folder, repeat, options))
    return rows


def scan_value(scans, key, faces):
    """Of a scan with so many faces: between the two measured ones beside it (in logarithms)."""
    scans = sorted(scans, key=lambda row: row["faces"])
    above = next((i for i, row in enumerate(scans) if row["faces"] >= faces), len(scans) - 1)
    a, b = scans[max(above, 1) - 1], scans[max(above, 1)]
    share = math.log(faces / a["faces"]) / math.log(b["faces"] / a["faces"])
    return math.exp((1 - share) * math.log(a[key]) + share * math.log(b[key]))


def show(rows):
    scans = [row for row in rows if row["family"] == "scan"]
    lines = [["family", "faces", "CPU s", "x scan", "peak MB", "x scan"]]
    for name in dict.fromkeys(row["family"] for row in rows):
        family = [row for row in rows if row["family"] == name]
        for row in family:
            lines.append([name, f"{row['faces']:,}", number(row["cpu"]),
                          number(row["cpu"] / scan_value(scans, "cpu", row["faces"])),
                          number(row["peak"] / 1e6),
                          number(row["peak"] / scan_value(scans, "peak", row["faces"]))])
        faces = [row["faces"] for row in family]
        lines.append(["growth", "", f"^{exponent(faces, [row['cpu'] for row in family]):.2f}", "",
                      f"^{exponent(faces, [row['peak'] for row in family]):.2f}", ""])
    align(lines)
