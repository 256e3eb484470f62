"""Parts of buildings. Walls and floors are stretched to any size: nothing on them may look stretched."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
THICK, HIGH = 0.06, 2.6   # half a wall's thickness, and its height


def wall():
    return Model("wall", "none", role="wall").of(PLASTER).block((-0.5, 0, -THICK), (0.5, HIGH, THICK))


def low_wall():
    w = Model("low_wall", "none", role="wall").of(PLASTER).block((-0.5, 0, -THICK), (0.5, 1.0, THICK))
    return w.block((-0.5, 1.0, -THICK - 0.02), (0.5, 1.04, THICK + 0.02))


def floor():
    return Model("floor", "none").of(Surface("boards", (0.80, 0.72, 0.60), 0.8)).block((-0.5, 0, -0.5), (0.5, 0.02, 0.5))


# Doors and windows are a little thicker than the wall that they stand in, so that they show on both of its sides.

def _leaf(model, left, right, handle):
    """A door's leaf with panels on both sides; `handle` is the side where it opens."""
    face, inset = 0.07, 0.06
    model.block((left, 0.005, -face), (right, 2.04, face))
    middle = (left + right) / 2
    for s in SIDES:
        near, far = (face, face + 0.014) if s > 0 else (-face - 0.014, -face)
        for a, b in ((left + inset, middle - 0.04), (middle + 0.04, right - inset)):
            for y in (0.2, 1.15):
                model.soft_block((a, y, near), (b, y + 0.78, far), 0.006)
    model.of(STEEL)
    edge = right if handle > 0 else left
    for s in SIDES:
        def layer(u0, u1, y0, y1, out0, out1):
            xs = sorted((edge - handle * u0, edge - handle * u1))
            zs = sorted((s * (face + out0), s * (face + out1)))
            model.block((xs[0], y0, zs[0]), (xs[1], y1, zs[1]))

        layer(0.048, 0.01, 0.98, 1.11, 0, 0.008)
        layer(0.037, 0.022, 1.05, 1.065, 0.008, 0.05)
        layer(0.15, 0.022, 1.048, 1.067, 0.036, 0.05)


def _door_frame(model, half):
    model.of(WHITE)
    for s in SIDES:
        model.block((s * (half + 0.025) - 0.025, 0, -0.09), (s * (half + 0.025) + 0.025, 2.1, 0.09))
    model.block((-half, 2.04, -0.09), (half, 2.1, 0.09))


def door():
    d = Model("door", role="opening")
    _leaf(d.of(OAK), -0.4, 0.4, 1)
    _door_frame(d, 0.4)
    return d


def double_door():
    d = Model("double_door", role="opening")
    _leaf(d.of(OAK), -0.8, -0.002, 1)
    _leaf(d.of(OAK), 0.002, 0.8, -1)
    _door_frame(d, 0.8)
    return d


def doorway():
    """A way through a wall without a door."""
    d = Model("doorway", role="opening")
    _door_frame(d, 0.4)
    return d


def _window(model, half, height):
    glass, bar, frame = 0.012, 0.04, 0.09
    model.of(WHITE)
    for s in SIDES:
        model.block((s * (half + 0.03) - 0.03, 0, -frame), (s * (half + 0.03) + 0.03, height, frame))
        model.block((-half, height - 0.06 if s > 0 else 0, -frame), (half, height if s > 0 else 0.06, frame))
    model.block((-0.025, 0.06, -bar), (0.025, height - 0.06, bar))
    cross = height * 0.64
    model.block((-half, cross, -bar), (-0.025, cross + 0.035, bar)).block((0.025, cross, -bar), (half, cross + 0.035, bar))
    for s in SIDES:
        z0, z1 = (frame, 0.14) if s > 0 else (-0.14, -frame)
        model.soft_block((-half - 0.06, 0, z0), (half + 0.06, 0.035, z1), 0.006)
    model.of(STEEL).block((-0.007, 0.62, bar), (0.007, 0.74, bar + 0.02))
    model.of(GLASS)
    into = 0.004  # the panes reach into the frame, so that no two faces lie in one plane
    for x0, x1 in ((-half, -0.025), (0.025, half)):
        model.block((x0 - into, 0.06 - into, -glass), (x1 + into, cross + into, glass))
        model.block((x0 - into, cross + 0.035 - into, -glass), (x1 + into, height - 0.06 + into, glass))


def window():
    w = Model("window", role="opening")
    _window(w, 0.54, 1.4)
    return w


def _wall_around(name, half, low, high):
    """A wall of three metres around an opening, as a part of its own."""
    w = Model(name, role="wall").of(PLASTER)
    for s in SIDES:
        x0, x1 = sorted((s * half, s * 1.5))
        w.block((x0, 0, -THICK), (x1, HIGH, THICK))
    w.block((-half, high, -THICK), (half, HIGH, THICK))
    if low > 0:
        w.block((-half, 0, -THICK), (half, low, THICK))
    return w


def wall_with_door():
    w = _wall_around("wall_with_door", 0.45, 0, 2.1)
    _leaf(w.of(OAK), -0.4, 0.4, 1)
    _door_frame(w, 0.4)
    return w


def wall_with_doorway():
    w = _wall_around("wall_with_doorway", 0.45, 0, 2.1)
    _door_frame(w, 0.4)
    return w


def wall_with_window():
    w = _wall_around("wall_with_window", 0.6, 0.85, 2.25)
    w.at(g.moved(0, 0.85, 0))
    _window(w, 0.54, 1.4)
    return w


def column():
    c = Model("column", "none")
    c.of(Surface("stone", (0.84, 0.82, 0.78), 0.9)).soft_block((-0.25, 0, -0.25), (0.25, 0.14, 0.25), 0.01)
    c.turned(0, 0, [(0.23, 0.14), (0.235, 0.2), (0.18, 0.26), (0.175, 0.6), (0.15, 2.5), (0.2, 2.58), (0.2, 2.66)], 24)
    return c.soft_block((-0.24, 2.66, -0.24), (0.24, 2.8, 0.24), 0.01)


def stairs():
    """A straight flight that rises one storey from its front to its back."""
    s = Model("stairs")
    steps, width, rise, going = 15, 1.0, 2.8 / 15, 0.26
    for i in range(steps):
        y, z = (i + 1) * rise, -i * going
        s.of(OAK).soft_block((-width / 2, y - 0.04, z - going - 0.01), (width / 2, y, z + 0.02), 0.006)
        s.of(WHITE).block((-width / 2 + 0.03, y - rise, z - 0.02), (width / 2 - 0.03, y - 0.04, z))
    length = steps * going
    s.of(WHITE)
    for side in SIDES:
        s.at(g.turned_y(90), g.moved(side * (width / 2 - 0.015), 0, 0))
        s.extruded([(-0.02, 0), (0.3, 0), (length, 2.8 - 0.35), (length, 2.72), (0, 0.1)], -0.015, 0.015)
    s.at().of(DARK)
    for side in SIDES:
        x = side * (width / 2 - 0.06)
        for i in range(0, steps, 2):
            s.rod((x, (i + 1) * rise, -i * going - 0.12), (x, (i + 1) * rise + 0.88, -i * going - 0.12), 0.012, 6)
        s.of(WALNUT).rod((x, rise + 0.88, -0.06), (x, 15 * rise + 0.9, -14 * going - 0.14), 0.028, 8).of(DARK)
    return s


def railing():
    r = Model("railing", "none").of(DARK)
    for i in range(11):
        r.rod((-0.5 + i * 0.1, 0, 0), (-0.5 + i * 0.1, 0.98, 0), 0.008, 6)
    r.block((-0.5, 0.06, -0.012), (0.5, 0.08, 0.012))
    return r.of(WALNUT).soft_block((-0.5, 0.97, -0.03), (0.5, 1.02, 0.03), 0.01)


MODELS = (wall, low_wall, floor, door, double_door, doorway, window, wall_with_door, wall_with_doorway, wall_with_window,
          column, stairs, railing)
