"""Exact references for the probe's answers: rationals, and sines to 2^-200. Nothing here is taken from the engine."""

from fractions import Fraction

BITS = 200
ONE = 1 << BITS


def _arctan_inverse(n):
    """arctan(1 / n) in units of 2^-BITS."""
    total, term, k = 0, ONE // n, 1
    while term:
        total += term // k if k % 4 == 1 else -(term // k)
        term //= n * n
        k += 2
    return total


PI = Fraction(16 * _arctan_inverse(5) - 4 * _arctan_inverse(239), ONE)  # Machin


def _series(x, first, n):
    total = term = first
    while term:
        term = -term * x * x // (ONE * ONE * n * (n + 1))
        if term == -1:
            break
        total += term
        n += 2
    return Fraction(total, ONE)


def sin_radians(x):
    """|x| up to pi / 2."""
    raw = int(x * ONE)
    return _series(raw, raw, 2)


def sin_turns(turns):
    """The sine of a fraction of a turn; exact where it is rational."""
    turns = turns % 1
    if turns >= Fraction(1, 2):
        return -sin_turns(turns - Fraction(1, 2))
    if turns > Fraction(1, 4):
        turns = Fraction(1, 2) - turns
    if turns == 0:
        return Fraction(0)
    if turns == Fraction(1, 4):
        return Fraction(1)
    return sin_radians(turns * 2 * PI)


def cos_turns(turns):
    return sin_turns(turns + Fraction(1, 4))


def multipliers(width, height, pn, pd, fov):
    """Pixels by which x / z and y / z are multiplied."""
    half = Fraction(fov) / 720
    d = Fraction(width, 2) * (1 if half == Fraction(1, 8) else cos_turns(half) / sin_turns(half))
    return d, d * Fraction(pn * height, pd * width)


def project(mode, point):
    mx, my = multipliers(*mode)
    x, y, z = point
    return Fraction(mode[0], 2) + mx * x / z, Fraction(mode[1], 2) - my * y / z


def view_axes(yaw, pitch, roll):
    sa, ca = sin_turns(Fraction(yaw, 65536)), cos_turns(Fraction(yaw, 65536))
    sb, cb = sin_turns(Fraction(pitch, 65536)), cos_turns(Fraction(pitch, 65536))
    sg, cg = sin_turns(Fraction(roll, 65536)), cos_turns(Fraction(roll, 65536))
    mix = lambda p, u, q, v: tuple(p * a + q * b for a, b in zip(u, v))
    right, up, forward = (ca, 0, -sa), (0, 1, 0), (sa, 0, ca)
    up, forward = mix(cb, up, -sb, forward), mix(cb, forward, sb, up)
    return mix(cg, right, sg, up), mix(cg, up, -sg, right), forward


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def to_view(eye, angles, point):
    offset = [p - e for p, e in zip(point, eye)]
    return tuple(dot(offset, axis) for axis in view_axes(*angles))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def texel(mode, corners, column, row):
    """u, v of the triangle's plane at the centre of a pixel, and 1 / z. corners: (x, y, z, u, v)."""
    mx, my = multipliers(*mode)
    ray = ((column + Fraction(1, 2) - Fraction(mode[0], 2)) / mx, (Fraction(mode[1], 2) - row - Fraction(1, 2)) / my, 1)
    a, b, c = (corner[:3] for corner in corners)
    normals = (cross(b, c), cross(c, a), cross(a, b))
    weights = [dot(normal, ray) for normal in normals]
    whole = sum(weights)
    return (dot(weights, [corner[3] for corner in corners]) / whole,
            dot(weights, [corner[4] for corner in corners]) / whole, whole / dot(a, normals[0]))


def coverage(corners, width=320, height=200):
    """{row: [columns]} of a triangle whose corners are rationals, in pixels, by the rule itself, a row at a time."""
    (ax, ay), (bx, by), (cx, cy) = corners
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if area == 0:
        return {}
    if area < 0:
        (bx, by), (cx, cy) = (cx, cy), (bx, by)
    edges = [((ax, ay), (bx, by)), ((bx, by), (cx, cy)), ((cx, cy), (ax, ay))]
    rows = {}
    for row in range(height):
        spans = [columns_inside(edge, Fraction(2 * row + 1, 2), width) for edge in edges]
        first, end = max(s[0] for s in spans), min(s[1] for s in spans)
        if first < end:
            rows[row] = (first, end)
    return rows


def columns_inside(edge, y, width):
    """Columns [first, end) of a row that lie on the inner side of an edge that runs clockwise (y down)."""
    (ax, ay), (bx, by) = edge
    dx, dy = bx - ax, by - ay
    if dy == 0:
        # A top edge runs to the right and owns its pixels; a bottom edge does not.
        inside = y >= ay if dx > 0 else y < ay
        return (0, width) if inside else (0, 0)
    crossing = ax + Fraction(dx) * (y - ay) / dy - Fraction(1, 2)
    first_right = -((-crossing.numerator) // crossing.denominator)  # the first column not left of the edge
    first_right = min(max(first_right, 0), width)
    return (first_right, width) if dy < 0 else (0, first_right)


def clip_area(mode, near, far, polygon):
    """The area on the screen, in square pixels, of a convex polygon: clipped exactly. `near` is not below 0."""
    mx, my = multipliers(*mode)
    tx, ty = Fraction(mode[0], 2) / mx, Fraction(mode[1], 2) / my
    planes = [(0, 0, 1, near), (0, 0, -1, -far), (1, 0, tx, 0), (-1, 0, tx, 0), (0, 1, ty, 0), (0, -1, ty, 0)]
    for plane in planes:
        polygon = _clip(polygon, plane)
    if any(z == 0 for x, y, z in polygon):
        return 0  # the sides of the view meet at the eye, which lies in the polygon then and sees it edge-on
    screen = [(mx * x / z, my * y / z) for x, y, z in polygon]
    return abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(screen, screen[1:] + screen[:1]))) / 2


def _clip(polygon, plane):
    result = []
    distances = [dot(plane[:3], p) - plane[3] for p in polygon]
    for i, p in enumerate(polygon):
        q, dp, dq = polygon[i - 1], distances[i], distances[i - 1]
        if dp * dq < 0:
            result.append(tuple((b * dp - a * dq) / (dp - dq) for a, b in zip(p, q)))
        if dp >= 0:
            result.append(p)
    return result
