"""What all figures are made with: the programs, and where files go."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent

PROGRAMS = {
    "spoctree-model": "tools",
    "spoctree-silhouettes": "tools",
    "spoctree-server": "server",
    "spoctree-client": "client",
    "spoctree-benchmark": "tools/benchmark",
    "compare_methods": "tests",
}


def build_release():
    """The release preset with its benchmarks, in the folder that is returned."""
    subprocess.run([ROOT / "tools" / "install-packages"], check=True)
    environment = os.environ | {"CCACHE_BASEDIR": str(ROOT), "CCACHE_NOHASHDIR": "1"}
    for command in (
        ["cmake", "--preset", "release", "-DSPOCTREE_BENCHMARKS=ON"],
        ["cmake", "--build", "--preset", "release", "--target", *PROGRAMS],
    ):
        done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"figures: {' '.join(command)}:\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return ROOT / "build" / "release"


class Workshop:
    """`output` is where figures go, `scratch` is for what nobody will look for."""

    def __init__(self, build, output, scratch):
        self.build = build
        self.output = output
        self.scratch = scratch

    def run(self, program, *arguments):
        """Standard output of a program that must succeed."""
        command = [self.build / PROGRAMS[program] / program, *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"figures: {' '.join(map(str, command))}: {done.stderr.strip()}")
        return done.stdout

    def model(self, name, *size):
        """The OFF file of a generated model, made when it is first asked for."""
        path = self.scratch / ("-".join([name, *map(str, size)]) + ".off")
        if not path.exists():
            self.run("spoctree-model", name, *size, "-o", path)
        return path
