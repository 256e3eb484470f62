"""Affine maps as three rows of four numbers. Lengths are metres along glTF's axes: x right, y up, z to the front."""
import math

IDENTITY = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0))


def apply(rows, point):
    return tuple(r[0] * point[0] + r[1] * point[1] + r[2] * point[2] + r[3] for r in rows)


def apply_to_normal(rows, normal):
    """The normal of a surface after a map, by the cofactors of its matrix."""
    x, y, z = (tuple(row[k] for row in rows) for k in range(3))
    cofactors = (cross(y, z), cross(z, x), cross(x, y))
    sign = -1 if mirrors(rows) else 1
    return tuple(sign * sum(cofactors[k][axis] * normal[k] for k in range(3)) for axis in range(3))


def then(inner, outer):
    """The map that does `inner` first and `outer` after it."""
    columns = [[inner[k][j] for k in range(3)] for j in range(4)]
    rows = []
    for row in outer:
        made = [sum(row[k] * column[k] for k in range(3)) for column in columns]
        made[3] += row[3]
        rows.append(tuple(made))
    return tuple(rows)


def mirrors(rows):
    (a, b, c, _), (d, e, f, _), (g, h, i, _) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) < 0


def moved(x=0, y=0, z=0):
    return ((1, 0, 0, x), (0, 1, 0, y), (0, 0, 1, z))


def scaled(x, y, z):
    return ((x, 0, 0, 0), (0, y, 0, 0), (0, 0, z, 0))


def _turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    rows = [list(row) for row in IDENTITY]
    u, v = (axis + 1) % 3, (axis + 2) % 3
    rows[u][u], rows[u][v], rows[v][u], rows[v][v] = c, -s, s, c
    return tuple(tuple(row) for row in rows)


def turned_x(degrees):
    return _turn(0, degrees)


def turned_y(degrees):
    return _turn(1, degrees)


def turned_z(degrees):
    return _turn(2, degrees)


def about(turn, x=0, y=0, z=0):
    """The turn about an axis through this point."""
    return then(then(moved(-x, -y, -z), turn), moved(x, y, z))


def leaning(degrees, y, z):
    """Leans backwards, the top towards -z, about the line y, z."""
    return about(turned_x(-degrees), 0, y, z)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normalized(v):
    length = math.sqrt(sum(part * part for part in v))
    return tuple(part / length for part in v)


def face_normal(corners):
    """Newell's, so that slivers do no harm."""
    normal = [0, 0, 0]
    for a, b in zip(corners, corners[1:] + corners[:1]):
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            normal[axis] += (a[u] - b[u]) * (a[v] + b[v])
    return normalized(normal)


def counter_clockwise(outline):
    twice_area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, outline[1:] + outline[:1]))
    return outline if twice_area > 0 else outline[::-1]


def triangles_of(outline):
    """Cuts a simple outline, counter-clockwise, into triangles of its indices by clipping ears (Meisters, 1975)."""
    def area(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])

    left, triangles = list(range(len(outline))), []
    while len(left) > 3:
        for i in range(len(left)):
            a, b, c = left[i - 1], left[i], left[(i + 1) % len(left)]
            p, q, r = outline[a], outline[b], outline[c]
            others = [outline[k] for k in left if k not in (a, b, c)]
            if area(p, q, r) > 1e-12 and not any(
                    area(p, q, o) >= 0 and area(q, r, o) >= 0 and area(r, p, o) >= 0 for o in others):
                triangles.append((a, b, c))
                del left[i]
                break
        else:
            raise ValueError("the outline crosses itself")
    return triangles + [tuple(left)]
