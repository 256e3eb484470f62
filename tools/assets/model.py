"""Models put together from solids."""
import math

import geometry as g

SMOOTH = math.cos(math.radians(50))  # where a profile bends less, the surface is round


def slopes_of(rings):
    """Returns for each part of a profile its normal (outward, upward) at its lower and at its upper end."""
    flat = []
    for below, above in zip(rings, rings[1:]):
        length = math.dist(below, above)
        flat.append(((above[1] - below[1]) / length, (below[0] - above[0]) / length))

    def at(i, other, ring):
        """The normal of part i at a ring, where it meets the other part or, at the ends, perhaps the axis."""
        outward, upward = flat[i]
        if 0 <= other < len(flat):
            beside = flat[other]
            if outward * beside[0] + upward * beside[1] > SMOOTH:
                return (outward + beside[0], upward + beside[1])
        elif rings[ring][0] == 0 and abs(upward) > SMOOTH:
            return (0, math.copysign(1, upward))
        return flat[i]

    return [(at(i, i - 1, i), at(i, i + 1, i + 1)) for i in range(len(flat))]


class Part:
    """The triangles of one surface."""

    def __init__(self, surface):
        self.surface = surface
        self.positions, self.normals, self.indices = [], [], []

    def face(self, corners, normals):
        first = len(self.positions)
        self.positions += corners
        self.normals += normals
        for i in range(2, len(corners)):
            self.indices += [first, first + i - 1, first + i]


class Model:
    """A model that a program places by its name.

    `front` is "+Z", or "none" for a thing that looks the same from all sides. A thing that `keeps_proportions`, as a
    tree does and a table does not, is not stretched by a size of its ground alone. `role` is what walls take it for:
    "wall" or "opening". The first surface used is the primary one, which a program's colour replaces.
    """

    def __init__(self, name, front="+Z", keeps_proportions=False, role=""):
        self.name, self.front, self.keeps_proportions, self.role = name, front, keeps_proportions, role
        self.parts = []
        self.map = g.IDENTITY

    def of(self, surface):
        """What follows is made of this."""
        known = [part for part in self.parts if part.surface.name == surface.name]
        self.part = known[0] if known else Part(surface)
        if not known:
            self.parts.append(self.part)
        return self

    def at(self, *maps):
        """What follows is moved by these maps, one after the other, until the next `at`."""
        self.map = g.IDENTITY
        for each in maps:
            self.map = g.then(self.map, each)
        return self

    def face(self, corners, normals=None):
        """A flat face, counter-clockwise seen from outside, or one of a rounded surface with a normal at each corner."""
        if g.mirrors(self.map):
            corners, normals = corners[::-1], normals[::-1] if normals else None
        corners = [g.apply(self.map, corner) for corner in corners]
        if normals:
            normals = [g.normalized(g.apply_to_normal(self.map, normal)) for normal in normals]
        self.part.face(corners, normals or [g.face_normal(corners)] * len(corners))
        return self

    def block(self, low, high):
        return self.soft_block(low, high, 0)

    def soft_block(self, low, high, bevel):
        """A block whose edges are cut off by `bevel`."""
        center = [(a + b) / 2 for a, b in zip(low, high)]
        half = [(b - a) / 2 for a, b in zip(low, high)]
        if min(half) <= bevel:
            raise ValueError(f"{self.name}: no block from {low} to {high} is left by a bevel of {bevel}")

        def corner(signs, face):  # drawn in by the bevel along the two axes that the face does not have
            return tuple(center[k] + signs[k] * (half[k] - (0 if k == face else bevel)) for k in range(3))

        def add(corners, reverse):
            self.face(corners[::-1] if reverse else corners)

        for a in range(3):
            b, c = (a + 1) % 3, (a + 2) % 3

            def sign(sa, sb, sc):
                signs = [0, 0, 0]
                signs[a], signs[b], signs[c] = sa, sb, sc
                return signs

            for s in (-1, 1):
                add([corner(sign(s, t, u), a) for t, u in ((-1, -1), (1, -1), (1, 1), (-1, 1))], s < 0)
                for t in (-1, 1) if bevel else ():  # the cut edge along c between the faces of a and b
                    add([corner(sign(s, t, -1), a), corner(sign(s, t, -1), b), corner(sign(s, t, 1), b),
                         corner(sign(s, t, 1), a)], s * t < 0)
        for k in range(8) if bevel else ():
            signs = [1 if k & 1 << axis else -1 for axis in range(3)]
            add([corner(signs, axis) for axis in range(3)], signs[0] * signs[1] * signs[2] < 0)
        return self

    def post(self, x, z, y0, w0, d0, y1, w1, d1, dx=0, dz=0):
        """An upright post around (x, z): w0 by d0 at y0, w1 by d1 at y1, where its centre is moved by (dx, dz)."""
        def ring(cx, y, cz, w, d):
            return [(cx - w / 2, y, cz + d / 2), (cx + w / 2, y, cz + d / 2), (cx + w / 2, y, cz - d / 2),
                    (cx - w / 2, y, cz - d / 2)]

        below, above = ring(x, y0, z, w0, d0), ring(x + dx, y1, z + dz, w1, d1)
        for i in range(4):
            self.face([below[i], below[i - 3], above[i - 3], above[i]])
        return self.face(above).face(below[::-1])

    def legs(self, w, d, top, upper, lower, splay=0):
        """Four posts at the corners of a w by d rectangle, leaning outward by `splay`."""
        for sx in (-1, 1):
            for sz in (-1, 1):
                self.post(sx * w / 2, sz * d / 2, 0, lower, lower, top, upper, upper, -sx * splay, -sz * splay)
        return self

    def turned(self, x, z, rings, sides=16):
        """A round upright solid through (radius, height) rings from below, with flat ends where the radius is not 0.
        Where its profile bends little, or comes to its axis bluntly, it is smooth."""
        slopes = slopes_of(rings)
        angles = [2 * math.pi * side / sides for side in range(sides)]
        around = [(math.sin(angle), math.cos(angle)) for angle in angles]

        def at(ring, side):
            (radius, y), (s, c) = rings[ring], around[side % sides]
            return (x + radius * s, y, z + radius * c)

        for i, (below, above) in enumerate(zip(rings, rings[1:])):
            for side in range(sides):
                corners = [(i, side)] + [(i, side + 1)] * (below[0] > 0) + [(i + 1, side + 1)]
                corners += [(i + 1, side)] * (above[0] > 0)
                self.face([at(*corner) for corner in corners],
                          [(around[s % sides][0] * slopes[i][ring - i][0], slopes[i][ring - i][1],
                            around[s % sides][1] * slopes[i][ring - i][0]) for ring, s in corners])
        if rings[0][0] > 0:
            self.face([at(0, -1 - side) for side in range(sides)])
        if rings[-1][0] > 0:
            self.face([at(len(rings) - 1, side) for side in range(sides)])
        return self

    def ball(self, x, y, z, radius, sides=16, steps=8, squash=1):
        """A sphere around a point, its height multiplied by `squash`."""
        rings = []
        for i in range(steps + 1):
            angle = math.pi * i / steps
            rings.append((0 if i in (0, steps) else radius * math.sin(angle), y - squash * radius * math.cos(angle)))
        return self.turned(x, z, rings, sides)

    def rod(self, start, end, radius, sides=8, end_radius=None):
        """A round bar between two points."""
        axis = g.normalized([b - a for a, b in zip(start, end)])
        side = g.normalized(g.cross(axis, (0, 0, 1) if abs(axis[2]) < 0.9 else (1, 0, 0)))
        other = g.cross(side, axis)
        length = math.dist(start, end)
        kept = self.map
        columns = list(zip(side, axis, other, start))
        self.map = g.then(tuple(columns), kept)
        self.turned(0, 0, [(radius, 0), (radius if end_radius is None else end_radius, length)], sides)
        self.map = kept
        return self

    def extruded(self, outline, z0, z1):
        """An outline of (x, y) corners, in either direction, drawn out from z0 to z1."""
        outline = g.counter_clockwise(outline)
        front, back = [(x, y, z1) for x, y in outline], [(x, y, z0) for x, y in outline]
        for i in range(len(outline)):
            self.face([front[i - 1], back[i - 1], back[i], front[i]])
        for triangle in g.triangles_of(outline):
            self.face([front[i] for i in triangle]).face([back[i] for i in triangle[::-1]])
        return self

    def leaf(self, root, middle, tip, width):
        """A pointed leaf from `root`, bent at `middle`, to `tip`; seen from both sides."""
        side = g.normalized((tip[2] - root[2], 0, root[0] - tip[0]))
        left = (middle[0] + side[0] * width / 2, middle[1], middle[2] + side[2] * width / 2)
        right = (middle[0] - side[0] * width / 2, middle[1], middle[2] - side[2] * width / 2)
        for half in ([root, right, left], [right, tip, left]):
            self.face(half).face(half[::-1])
        return self

    def centered(self):
        """Moves the model so that its box is centred over the origin and stands on the ground."""
        low, high = self.box()
        by = (-(low[0] + high[0]) / 2, -low[1], -(low[2] + high[2]) / 2)
        for part in self.parts:
            part.positions = [tuple(a + b for a, b in zip(point, by)) for point in part.positions]
        return self

    def box(self):
        points = [point for part in self.parts for point in part.positions]
        return [min(axis) for axis in zip(*points)], [max(axis) for axis in zip(*points)]

    def triangles(self):
        return sum(len(part.indices) // 3 for part in self.parts)
