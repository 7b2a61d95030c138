"""Asks oblong-probe thousands of random and extreme queries and holds its answers to exact references (exact.py).

    check.py PROGRAM [--seed N] [--scale FACTOR]
    check.py --queries [--seed N] [--scale FACTOR]      prints the queries, a line each, and asks nothing

Prints the largest error of each kind of query; exits with 1 if one is too large.
"""

import argparse
import os
import pathlib
import random
import struct
import subprocess
import sys
from fractions import Fraction

import exact

rng = random.Random(1)
MODES = [(320, 200, 4, 3), (320, 240, 4, 3), (640, 480, 4, 3), (640, 480, 37, 20), (321, 201, 4, 3), (1280, 800, 8, 5),
         (360, 480, 4, 3), (16384, 16384, 1, 1), (1, 1, 1, 1), (7, 3, 16, 9)]


def number(value):
    """A multiple of 1/256 as a decimal."""
    text = f"{float(value):.8f}".rstrip("0").rstrip(".")
    return text if text not in ("", "-0") else "0"


def numbers(values):
    return " ".join(number(v) for v in values)


def length(limit=32767):
    """Lengths of every size."""
    size = rng.choice([limit, limit, 1000, 16, 1]) * 256
    return Fraction(rng.randint(-min(size, limit * 256), min(size, limit * 256)), 256)


def any_point():
    return tuple(length() for _ in range(3))


def any_fov(low=1, high=179):
    return rng.choice([str(rng.randint(low, high)), f"{rng.uniform(low, high):.3f}", "90", "60", "120"])


def any_mode(fovs=any_fov):
    return rng.choice(MODES) if rng.random() < 0.6 else MODES[0], fovs()


def mode_text(mode, fov):
    return " ".join(map(str, mode)) + " " + fov


class Check:
    """Queries of one kind: (line, judge), where judge(answer) gives an error and what was expected."""

    def __init__(self, name, limit, unit="pixel"):
        self.name, self.limit, self.unit, self.queries = name, limit, unit, []

    def add(self, line, judge):
        self.queries.append((line, judge))

    def report(self, answers):
        worst, line, answer = max(((judge(answer), line, answer) for (line, judge), answer in
                                   zip(self.queries, answers)), key=lambda t: t[0])
        print(f"{self.name}: {len(self.queries)} queries, largest error {float(worst):.3g} {self.unit}"
              f" (limit {float(self.limit):.3g})")
        if worst > self.limit:
            print(f"  at: {line[:300]}\n  answer: {answer[:300]}")
        return worst <= self.limit


def values_of(answer):
    return [Fraction(text) for text in answer.split()]


def distance_judge(expected):
    def judge(answer):
        try:
            values = values_of(answer)
        except ValueError:
            return float("inf")
        if len(values) != len(expected):
            return float("inf")
        return max(abs(a - b) for a, b in zip(values, expected))
    return judge


def text_judge(expected):
    return lambda answer: 0 if answer == expected else float("inf")


def project_check(count):
    check = Check("project", Fraction(1, 200))
    for _ in range(count):
        mode, fov = any_mode(lambda: any_fov() if rng.random() < 0.8 else rng.choice(["0.01", "179.99", "0.5", "179.5"]))
        p = any_point()
        expected = exact.project((*mode, fov), p) if p[2] > 0 else None
        check.add(f"project {mode_text(mode, fov)} {numbers(p)}",
                  distance_judge(expected) if expected else text_judge("behind"))
    return check


def view_check(count):
    check = Check("view", Fraction(1, 200))
    for _ in range(count):
        mode, fov = any_mode()
        eye, p = any_point(), any_point()
        if rng.random() < 0.5:
            p = tuple(e + length(200) for e in eye)
            p = tuple(max(min(c, Fraction(32767)), Fraction(-32767)) for c in p)
        angles = [rng.choice([rng.randint(-200000, 200000), 16384 * rng.randint(-9, 9)]) for _ in range(3)]
        view = exact.to_view(eye, angles, p)
        line = f"view {mode_text(mode, fov)} {numbers(eye)} {' '.join(map(str, angles))} {numbers(p)}"
        judge = text_judge("behind")
        if view[2] > 0:
            judge = distance_judge((*exact.project((*mode, fov), view), view[2]))
        check.add(line, judge)
    return check


def triangle_coordinates(scale):
    reach = rng.choice([20, 20, 340, 340, 2048])
    low = 0 if reach == 340 else -reach
    coordinate = lambda: rng.randint(low * scale, reach * scale)
    if reach == 20:
        cx, cy = rng.randint(0, 320) * scale, rng.randint(0, 200) * scale
        shape = rng.randint(1, 20 * scale)
        return [(cx + rng.randint(-shape, shape), cy + rng.randint(-shape, shape)) for _ in range(3)]
    points = [(coordinate(), coordinate()) for _ in range(3)]
    if rng.random() < 0.3:  # centres and whole pixels: where only the rule decides
        points = [((x // scale) * scale + scale // 2, (y // scale) * scale + scale // 2) for x, y in points]
    if rng.random() < 0.2:
        points[1] = (points[0][0] + rng.randint(-2, 2), points[1][1])
    if rng.random() < 0.2:
        points[2] = (points[2][0], points[1][1])
    return points


def coverage_answer(rows):
    return " ".join([str(len(rows))] + [f"{row} {first} {end}" for row, (first, end) in sorted(rows.items())])


def coverage_check(count):
    check = Check("coverage", 0, "(0 is right)")
    for _ in range(count):
        scale = rng.choice([16, 256])
        points = triangle_coordinates(scale)
        rows = exact.coverage([(Fraction(x, scale), Fraction(y, scale)) for x, y in points])
        check.add(f"coverage {scale} " + " ".join(f"{x} {y}" for x, y in points), text_judge(coverage_answer(rows)))
    return check


def mesh_line(scale, vertices, triangles):
    return (f"mesh {scale} {len(vertices)} " + " ".join(f"{x} {y}" for x, y in vertices) + f" {len(triangles)}" +
            "".join(f" {a} {b} {c}" for a, b, c in triangles))


def tiling_mesh(scale):
    """A grid of jittered vertices that covers the raster: every pixel exactly once."""
    across, down = rng.randint(1, 12), rng.randint(1, 9)
    jitter = min(320 // across, 200 // down) * scale // 4
    move = lambda is_inner: rng.randint(-jitter, jitter) if is_inner else 0
    vertices = [(i * 320 * scale // across + move(0 < i < across), j * 200 * scale // down + move(0 < j < down))
                for j in range(down + 1) for i in range(across + 1)]
    triangles = []
    for j in range(down):
        for i in range(across):
            a, b = j * (across + 1) + i, (j + 1) * (across + 1) + i
            halves = [(a, a + 1, b + 1), (a, b + 1, b)] if rng.random() < 0.5 else [(a, a + 1, b), (a + 1, b + 1, b)]
            triangles += [tuple(rng.sample(half, 3)) for half in halves]
    rng.shuffle(triangles)
    return vertices, triangles


def mesh_check(count):
    check = Check("mesh", 0, "(0 is right)")
    for _ in range(count):
        scale = rng.choice([16, 256])
        check.add(mesh_line(scale, *tiling_mesh(scale)), text_judge("0 64000 0"))
        triangles = [triangle_coordinates(scale) for _ in range(3)]
        counts = [[0] * 320 for _ in range(200)]
        for triangle in triangles:
            for row, (first, end) in exact.coverage([(Fraction(x, scale), Fraction(y, scale)) for x, y in triangle]).items():
                for column in range(first, end):
                    counts[row][column] += 1
        totals = [sum(sum(1 for n in row if min(n, 2) == k) for row in counts) for k in range(3)]
        check.add(mesh_line(scale, sum(triangles, []), [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(3)]),
                  text_judge(" ".join(map(str, totals))))
    return check


def random_triangle(mode, fov):
    """Corners in view at any depth: near ones, far ones, and both in one triangle."""
    mx, my = (float(m) for m in exact.multipliers(*mode, fov))
    corners = []
    texels = rng.choice([64, 1024, 32767])
    deepest = rng.choice([16, 400, 4000, 32767])
    for _ in range(3):
        z = rng.choice([rng.uniform(4, deepest), 4, deepest])
        x = (rng.uniform(-0.2, 1.2) - 0.5) * mode[0] / mx * z
        y = (rng.uniform(-0.2, 1.2) - 0.5) * mode[1] / my * z
        xyz = [Fraction(int(max(min(c, 32767), -32767) * 256), 256) for c in (x, y, z)]
        corners.append((*xyz, *(Fraction(rng.randint(-texels * 256, texels * 256), 256) for _ in range(2))))
    return corners


def grazing_triangle(mode, fov):
    """A floor or a wall near the eye's own height, from 4 units to far."""
    h = Fraction(rng.choice([1, 16, 256, 4096, 48 * 256]), 256)
    far, near = Fraction(rng.choice([4000, 12800, 32767])), Fraction(4)
    spread = min(far * Fraction(3, 2), Fraction(32767))
    texels = rng.choice([1, 8])
    corners = [(-spread, -h, far), (spread, -h, far), (Fraction(rng.randint(-2, 2)), -h, near)]
    return [(x, y, z, Fraction(int(x * 256 / texels), 256), Fraction(int(z * 256 / texels), 256)) for x, y, z in corners]


def span_inside(mode, fov, corners):
    """A row and columns whose centres lie inside the triangle, or nothing."""
    screen = [exact.project((*mode, fov), corner[:3]) for corner in corners]
    rows = exact.coverage(screen, mode[0], mode[1])
    rows = {row: span for row, span in rows.items() if span[1] - span[0] > 2}
    if not rows:
        return None
    row = rng.choice(list(rows))
    first, end = rows[row]
    first, end = first + 1, end - 1
    if end - first > 40 and rng.random() < 0.7:
        first = rng.randint(first, end - 40)
        end = first + 40
    return row, first, end


def texspan_check(count, limit=Fraction(1, 16), name=None):
    check = Check("texspan " + (name or ""), limit, "texel")
    while len(check.queries) < count:
        mode = rng.choice([MODES[0]] * 4 + [MODES[1], MODES[2], MODES[4], MODES[5]])
        fov = any_fov(30, 140)
        corners = random_triangle(mode, fov) if rng.random() < 0.7 else grazing_triangle(mode, fov)
        span = span_inside(mode, fov, corners)
        if not span:
            continue
        row, first, end = span
        expected = []
        for column in range(first, end):
            expected += exact.texel((*mode, fov), corners, column, row)[:2]
        line = f"{mode_text(mode, fov)} {' '.join(numbers(c) for c in corners)} {row} {first} {end}"
        check.add((f"texspanq {name} " if name else "texspan ") + line, distance_judge(expected))
    return check


def wide_texspan_check(count):
    """Whole rows of very wide modes, of which a sample of pixels is looked at."""
    check = Check("texspan, wide", Fraction(1, 64), "texel")
    while len(check.queries) < count:
        mode, fov = rng.choice([(3840, 40, 16, 9), (16384, 9, 16, 9), (32768, 5, 4, 3)]), any_fov(30, 140)
        corners = random_triangle(mode, fov) if rng.random() < 0.5 else grazing_triangle(mode, fov)
        span = span_inside(mode, fov, corners)
        if not span or span[2] - span[1] < 1000:
            continue
        row, first, end = span
        columns = [first, end - 1] + [rng.randrange(first, end) for _ in range(20)]
        expected = [exact.texel((*mode, fov), corners, column, row)[:2] for column in columns]

        def judge(answer, at=[column - first for column in columns], size=end - first, expected=sum(expected, ())):
            values = answer.split()
            if len(values) != 2 * size:
                return float("inf")
            return distance_judge(expected)(" ".join(v for i in at for v in values[2 * i:2 * i + 2]))
        line = f"{mode_text(mode, fov)} {' '.join(numbers(c) for c in corners)} {row} {first} {end}"
        check.add("texspan " + line, judge)
    return check


def clip_polygon_corners():
    """A convex polygon in a plane, corners exactly in it: a triangle, or a parallelogram. Some are seen edge-on: their
    plane goes through the eye."""
    a, b, c = any_point(), any_point(), any_point()
    if rng.random() < 0.1:
        b = tuple(rng.randint(-2, 2) * q for q in a)
        c = tuple(rng.randint(-1, 1) * q + rng.randint(-1, 1) * r for q, r in zip(a, c))
        return [a, b, c] if all(abs(x) <= 32767 for corner in (b, c) for x in corner) else [a, a, a]
    if rng.random() < 0.6:
        return [a, b, c]
    corners = [a, b, tuple(q + r - p for p, q, r in zip(a, b, c)), c]
    return corners if all(abs(x) <= 32767 for corner in corners for x in corner) else [a, b, c]


def relative_judge(expected):
    """Against 1 % of the area, and at least of 100 square pixels; nothing is exactly 0."""
    def judge(answer):
        if expected == 0:
            return 0 if answer == "0" else 1
        return abs(Fraction(answer) - expected) / max(expected, 100)
    return judge


def clip_check(count):
    check = Check("clip", Fraction(1, 100), "of the area")
    for _ in range(count):
        mode, fov = any_mode(lambda: any_fov(2, 170))
        near, far = Fraction(rng.choice([-256, 0, 1, 64, 256, 1024, 4096]), 256), Fraction(rng.choice([8192, 32767, 100]))
        corners = clip_polygon_corners()
        expected = exact.clip_area((*mode, fov), max(near, 0), far, corners)
        check.add(f"clip {mode_text(mode, fov)} {numbers([near, far])} {len(corners)} " +
                  " ".join(numbers(c) for c in corners), relative_judge(expected))
    return check


def number_check(count):
    check = Check("sin, cos, sqrt, recip", Fraction(1, 1 << 30), "(relative)")
    for _ in range(count):
        angle = rng.choice([rng.randint(-1 << 70, 1 << 70), rng.randint(0, 65535), 8192 * rng.randint(-20, 20)])
        check.add(f"sin {angle}", distance_judge([exact.sin_turns(Fraction(angle, 65536))]))
        check.add(f"cos {angle}", distance_judge([exact.cos_turns(Fraction(angle, 65536))]))
        n = rng.choice([rng.randint(1, 100), rng.randint(1, (1 << 31) - 1), (1 << rng.randint(1, 31)) - 1])
        check.add(f"recip {n}", lambda answer, n=n: abs(Fraction(answer) * n / 65536 - 1))
        check.add(f"sqrt {n}", lambda answer, n=n: abs(Fraction(answer) ** 2 * 65536 / n - 1))
    return check


def ask(program, lines):
    result = subprocess.run([program], input="\n".join(lines) + "\n", capture_output=True, text=True, timeout=3600)
    answers = result.stdout.split("\n")
    if result.returncode != 0 or len(answers) != len(lines) + 1:
        sys.exit(f"exit status {result.returncode}, {len(answers) - 1} answers to {len(lines)} queries\n{result.stderr}")
    return answers[:-1]


def shared_levels():
    """Real levels stand beside the project, or where OBLONG_SHARED says; without them that part is left out."""
    project = pathlib.Path(__file__).resolve().parent.parent.parent
    for folder in [project / ".." / "shared", pathlib.Path(os.environ.get("OBLONG_SHARED", "/nowhere"))]:
        levels = sorted((folder / "levels").glob("*.bsp"))
        if levels:
            return levels
    print("leaf: no folder shared/ beside the project, and no OBLONG_SHARED in the environment: left out", file=sys.stderr)
    return []


class LevelFile:
    """Planes, nodes and leaves of a version-29 file, as its bytes say."""

    def __init__(self, path):
        self.data = path.read_bytes()
        self.planes, self.nodes, self.leaves, self.models = self.lump(1), self.lump(5), self.lump(10), self.lump(14)

    def lump(self, index):
        return struct.unpack_from("<ii", self.data, 4 + 8 * index)[0]

    def plane(self, index):
        *normal, distance = struct.unpack_from("<4f", self.data, self.planes + 20 * index)
        return [Fraction(n) for n in normal], Fraction(distance)

    def random_plane(self):
        return self.plane(rng.randrange((struct.unpack_from("<ii", self.data, 12)[1]) // 20))

    def leaf(self, point):
        index = struct.unpack_from("<i", self.data, self.models + 36)[0]
        while index >= 0:
            plane, front, back = struct.unpack_from("<ihh", self.data, self.nodes + 24 * index)
            normal, distance = self.plane(plane)
            index = front if exact.dot(normal, point) > distance else back
        return -1 - index, struct.unpack_from("<i", self.data, self.leaves + 28 * (-1 - index))[0]


def leaf_check(count):
    """Points anywhere, and points as near to a plane as multiples of 1/256 come."""
    check = Check("leaf", 0, "(0 is right)")
    for path in shared_levels():
        level = LevelFile(path)
        for _ in range(count):
            point = [Fraction(rng.randint(-2048 * 256, 2048 * 256), 256) for _ in range(3)]
            normal, distance = level.random_plane()
            if rng.random() < 0.7:
                axis = max(range(3), key=lambda i: abs(normal[i]))
                off = (distance - exact.dot(normal, point)) / normal[axis]
                point[axis] += Fraction(round(off * 256) + rng.randint(-1, 1), 256)
            if max(map(abs, point)) > 32767:
                continue
            index, contents = level.leaf(point)
            check.add(f"leaf {path} {numbers(point)}", text_judge(f"{index} {contents}"))
    return check


def main():
    arguments = argparse.ArgumentParser()
    what = arguments.add_mutually_exclusive_group(required=True)
    what.add_argument("program", nargs="?")
    what.add_argument("--queries", action="store_true", help="print the queries, and ask nothing")
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--scale", type=float, default=1)
    options = arguments.parse_args()
    rng.seed(options.seed)
    checks = [make(max(int(count * options.scale), 1)) for make, count in (
        (project_check, 1000), (view_check, 600), (coverage_check, 500), (mesh_check, 10), (texspan_check, 250),
        (wide_texspan_check, 60), (clip_check, 600), (number_check, 300), (leaf_check, 500))]
    if options.queries:
        print(*(line for check in checks for line, _ in check.queries), sep="\n")
        return
    are_right = [check.report(ask(options.program, [line for line, _ in check.queries])) for check in checks
                 if check.queries]
    sys.exit(0 if all(are_right) else 1)


if __name__ == "__main__":
    main()
