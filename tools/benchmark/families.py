"""Models of the kinds that parts and exports have and scans have not, in every size, as binary STL.

Coordinates are rounded to single precision: what was flat, or one turned face, is so up to noise.
"""

import math
import struct
import sys


def lathe(profile, sides):
    """Turns a profile of (radius, height) upwards about the z axis; radius 0 only at its ends."""
    points, triangles, rings = [], [], []
    for radius, z in profile:
        first = len(points)
        if radius == 0:
            points.append((0.0, 0.0, z))
            rings.append([first] * sides)
            continue
        for k in range(sides):
            angle = 2 * math.pi * k / sides
            points.append((radius * math.cos(angle), radius * math.sin(angle), z))
        rings.append(range(first, first + sides))
    for below, above in zip(rings, rings[1:]):
        for k in range(sides):
            l = (k + 1) % sides
            if below[k] != below[l]:
                triangles.append((below[k], below[l], above[l]))
            if above[k] != above[l]:
                triangles.append((below[k], above[l], above[k]))
    return points, triangles


def torus(n):
    m = n // 2
    points = []
    for i in range(n):
        for j in range(m):
            a, b = 2 * math.pi * i / n, 2 * math.pi * j / m
            radius = 10 + 3 * math.cos(b)
            points.append((radius * math.cos(a), radius * math.sin(a), 3 * math.sin(b)))
    triangles = []
    for i in range(n):
        for j in range(m):
            k, l = (i + 1) % n, (j + 1) % m
            p, q, r, s = i * m + j, k * m + j, k * m + l, i * m + l
            triangles += [(p, q, r), (p, r, s)]
    return points, triangles


def vase(n):
    m = n // 2
    wall = [(3 + math.sin(7 * k / m) + 0.3 * math.sin(23 * k / m), 10 * k / m)
            for k in range(m + 1)]
    return lathe([(0, 0), *wall, (0, 10)], n)


def shaft(n):
    """Shoulders and cones, long thin faces all around."""
    profile, z = [(0, 0)], 0.0
    for k in range(max(2, n // 8)):
        radius = 1 + 0.1 * ((k * 7) % 5)
        profile += [(radius, z), (radius, z + 0.1)]
        z += 0.13 if k % 2 else 0.1
    return lathe([*profile, (0, profile[-1][1])], n)


def sphere(n):
    m = n // 2
    rings = [(math.sin(math.pi * k / m), -math.cos(math.pi * k / m)) for k in range(1, m)]
    return lathe([(0, -1), *rings, (0, 1)], n)


def poles(n):
    """A sphere of n meridians and few parallels: its polar triangles are long and thin."""
    rings = [(math.sin(math.pi * k / 6), -math.cos(math.pi * k / 6)) for k in range(1, 6)]
    return lathe([(0, -1), *rings, (0, 1)], n)


def icosphere(n):
    """The icosahedron's 20 faces, each divided into n * n."""
    g = (1 + math.sqrt(5)) / 2
    corners = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g),
               (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    number, points, triangles = {}, [], []

    def point(face, i, j):
        weights = zip(face, (n - i - j, i, j))
        key = tuple(sorted((corner, weight) for corner, weight in weights if weight))
        if key not in number:
            mean = [sum(weight * corners[corner][axis] for corner, weight in key)
                    for axis in range(3)]
            length = math.sqrt(sum(x * x for x in mean))
            number[key] = len(points)
            points.append(tuple(x / length for x in mean))
        return number[key]

    for face in faces:
        for i in range(n):
            for j in range(n - i):
                triangles.append((point(face, i, j), point(face, i + 1, j), point(face, i, j + 1)))
                if i + j < n - 1:
                    triangles.append((point(face, i + 1, j), point(face, i + 1, j + 1),
                                      point(face, i, j + 1)))
    return points, triangles


def fan(n):
    """Two points and a wavy rim: at each point n triangles, of which few are flat with others."""
    points = [(0, 0, 0.5)]
    for k in range(n):
        angle = 2 * math.pi * k / n
        radius = 2 + 0.3 * math.sin(9 * angle)
        points.append((radius * math.cos(angle), radius * math.sin(angle),
                       1 + 0.1 * math.sin(5 * angle)))
    points.append((0, 0, -1))
    triangles = []
    for k in range(n):
        a, b = 1 + k, 1 + (k + 1) % n
        triangles += [(0, a, b), (n + 1, b, a)]
    return points, triangles


def dented_fan(n):
    """A can with a sunk lid: fans of n triangles at two vertices."""
    rim = [(2 * math.cos(2 * math.pi * k / n), 2 * math.sin(2 * math.pi * k / n))
           for k in range(n)]
    points = ([(0, 0, 0.2)] + [(x, y, 1) for x, y in rim] + [(x, y, 0) for x, y in rim]
              + [(0, 0, -1)])
    triangles = []
    for k in range(n):
        a, b = 1 + k, 1 + (k + 1) % n
        triangles += [(0, a, b), (2 * n + 1, n + b, n + a), (a, n + a, n + b), (a, n + b, b)]
    return points, triangles


# Name, how it is made, four sizes, further options of `spoctree-server build`.
FAMILIES = (
    ("torus", torus, (60, 120, 240, 360), []),
    ("vase", vase, (80, 160, 222, 320), []),
    ("vase, tolerance 0", vase, (80, 160, 222, 320), ["--flat-tolerance", "0"]),
    ("shaft", shaft, (120, 240, 360, 480), []),
    ("sphere", sphere, (72, 100, 142, 200), []),
    ("sphere, tolerance 0", sphere, (72, 100, 142, 200), ["--flat-tolerance", "0"]),
    ("poles", poles, (250, 500, 1000, 2000), []),
    ("poles, tolerance 0", poles, (250, 500, 1000, 2000), ["--flat-tolerance", "0"]),
    ("icosphere", icosphere, (16, 24, 32, 48), []),
    ("fan", fan, (2000, 4000, 8000, 16000), []),
    ("dented fan", dented_fan, (1000, 2000, 4000, 8000), []),
)


def write_stl(path, points, triangles):
    packed = [struct.pack("<3f", *point) for point in points]
    with open(path, "wb") as out:
        out.write(bytes(80) + struct.pack("<I", len(triangles)))
        for a, b, c in triangles:
            out.write(bytes(12) + packed[a] + packed[b] + packed[c] + bytes(2))


def main():
    """families.py NAME SIZE FILE.stl; prints the number of faces."""
    name, size, path = sys.argv[1:]
    make = next(make for family, make, _, _ in FAMILIES if family == name)
    points, triangles = make(int(size))
    write_stl(path, points, triangles)
    print(len(triangles))


if __name__ == "__main__":
    main()
