"""Runs the programs that are measured."""

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAMS = ROOT / "build" / "release"
SERVER = PROGRAMS / "server" / "spoctree-server"
CLIENT = PROGRAMS / "client" / "spoctree-client"
DRACO_BITS = 14

# The last has a header that the others include.
PEERS = ("draco", "libocct-foundation-dev", "libocct-modeling-data-dev",
         "libocct-modeling-algorithms-dev", "libocct-visualization-dev")


def fail(text):
    sys.exit(f"bench: {text}")


def run(command):
    """Seconds of wall and of all cores, and peak memory in bytes, of a program that must succeed."""
    with tempfile.TemporaryFile() as said:
        start = time.perf_counter()
        process = subprocess.Popen(command, stdout=said, stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            said.seek(0)
            fail(f"{' '.join(map(str, command))}: {said.read().decode(errors='replace').strip()}")
    return {"wall": wall, "cpu": usage.ru_utime + usage.ru_stime, "peak": usage.ru_maxrss * 1024}


def best_of(count, command):
    runs = [run(command) for _ in range(count)]
    best = min(runs, key=lambda one: one["wall"])
    return best | {"cpu": min(one["cpu"] for one in runs)}


def prepare():
    """Installs what is missing, and builds."""
    subprocess.run([ROOT / "tools" / "install-packages", *PEERS], check=True)
    environment = os.environ | {"CCACHE_BASEDIR": str(ROOT), "CCACHE_NOHASHDIR": "1"}
    for command in (
        ["cmake", "--preset", "release", "-DSPOCTREE_BENCHMARKS=ON"],
        ["cmake", "--build", "--preset", "release", "--target", "spoctree-server",
         "spoctree-client", "spoctree-model", "spoctree-benchmark"],
    ):
        done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            fail(f"{' '.join(command)}:\n{done.stdout[-4000:]}{done.stderr[-4000:]}")


def make_spheres(folder):
    models = []
    for bands in (16, 32, 64, 128, 256):
        models.append(folder / f"wavy-sphere-{bands}.off")
        run([PROGRAMS / "tools" / "spoctree-model", "wavy-sphere", str(bands), "-o", models[-1]])
    return models


def measure_build(mesh, folder, repeat):
    model = folder / "model.spo"
    result = best_of(repeat, [SERVER, "build", mesh, "-o", model])
    levels = subprocess.run([CLIENT, "levels", model, "--json"],
                            check=True, capture_output=True, text=True)
    levels = json.loads(levels.stdout)
    result["bytes"] = levels["total_bytes"]
    result["bytes_per_level"] = [level["bytes"] for level in levels["levels"]]
    return result


def measure_rebuild(folder):
    return run([CLIENT, "rebuild", folder / "model.spo", "-o", folder / "rebuilt.off"])


def measure_draco(folder, repeat):
    """draco_encoder reads OBJ, STL and PLY, of PLY not every kind, and no face of many corners: it
    is given the model's own boundary, rebuilt, as an OBJ of triangles (fans: it encodes what joins
    which corners, not where diagonals run)."""
    obj = folder / "mesh.obj"
    with open(folder / "rebuilt.off") as off, open(obj, "w") as out:
        assert off.readline().strip() == "OFF"
        points, faces, _ = map(int, off.readline().split())
        for _ in range(points):
            out.write("v " + off.readline())
        for _ in range(faces):
            corners = [str(int(word) + 1) for word in off.readline().split()[1:]]
            for b, c in zip(corners[1:], corners[2:]):
                out.write(f"f {corners[0]} {b} {c}\n")
    drc = folder / "mesh.drc"
    result = best_of(repeat, ["draco_encoder", "-i", obj, "-o", drc, "-qp", str(DRACO_BITS)])
    return result | {"bytes": drc.stat().st_size}


def measure_parts(meshes, parts, peers_up_to):
    """{mesh name: {part: benchmark}}; `parts` are regular expressions."""
    done = subprocess.run(
        [PROGRAMS / "tools" / "benchmark" / "spoctree-benchmark", "--benchmark_format=json",
         f"--benchmark_filter=^({'|'.join(parts)})/", f"--peers-up-to={peers_up_to}", *meshes],
        stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        fail("spoctree-benchmark failed")
    measured = {}
    for one in json.loads(done.stdout)["benchmarks"]:
        part, mesh = one["name"].split("/")[:2]
        if one.get("error_occurred"):
            print(f"{mesh}: no {part}: {one['error_message']}", file=sys.stderr)
        else:
            measured.setdefault(mesh, {})[part] = one
    return measured
