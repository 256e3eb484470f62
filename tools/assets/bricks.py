"""Bricks with studs: a stud's square is 8 mm wide, a plate 3.2 mm high and a brick as high as three plates.

In units of 0.0016 m a stud's square is 5 wide, a plate 2 high, a brick 6 high.
"""
import math

import geometry as g
from model import Model
from surfaces import GLASS, Surface

STUD, PLATE, BRICK = 0.008, 0.0032, 0.0096
GAP = 0.0001      # between neighbours, so that one sees that there are two
BEVEL = 0.0003
PLASTIC = Surface("plastic", (0.75, 0.18, 0.15), 0.3)
GREY = Surface("grey plastic", (0.62, 0.64, 0.66), 0.35)
DARK = Surface("dark plastic", (0.22, 0.23, 0.25), 0.4)
CLEAR = Surface("clear plastic", (0.35, 0.62, 0.80), 0.08, 0, 0, 0.55)
GLOWING = Surface("glow", (0.98, 0.62, 0.18), 0.5, 0, 0.8)


def _studs(model, columns, rows, top, skip=()):
    """Studs on a top that is centred over the origin."""
    few = columns * rows <= 16
    low = top - 0.0002   # within the body, so that no two faces lie on each other
    rings = [(0.0024, low), (0.0024, top + 0.0015), (0.0022, top + 0.0017)] if few else [(0.0024, low), (0.0024, top + 0.0017)]
    for i in range(columns):
        for k in range(rows):
            if (i, k) in skip:
                continue
            x, z = (i - (columns - 1) / 2) * STUD, (k - (rows - 1) / 2) * STUD
            model.turned(x, z, rings, 16 if few else 10)


def _body(model, columns, rows, height, y=0):
    half, deep = columns * STUD / 2 - GAP, rows * STUD / 2 - GAP
    model.soft_block((-half, y, -deep), (half, y + height, deep), BEVEL)


def _block(name, columns, rows, height):
    m = Model(name, "none").of(PLASTIC)
    _body(m, columns, rows, height)
    _studs(m, columns, rows, height)
    return m


def brick(columns, rows):
    return lambda: _block(f"brick_{columns}x{rows}", columns, rows, BRICK)


def plate(columns, rows):
    return lambda: _block(f"plate_{columns}x{rows}", columns, rows, PLATE)


def tile(columns, rows):
    """A plate without studs."""
    def make():
        m = Model(f"tile_{columns}x{rows}", "none").of(PLASTIC)
        _body(m, columns, rows, PLATE)
        return m
    return make


def _along_x(model):
    """Outlines that follow are drawn in depth and height: their x runs from the back to the front."""
    return model.at(g.turned_y(-90))


def slope(columns):
    """Two deep: studs at its back, a slope down to its front."""
    def make():
        m = Model(f"slope_{columns}x2").of(PLASTIC)
        half, deep = columns * STUD / 2 - GAP, STUD - GAP
        _along_x(m).extruded([(-deep, 0), (deep, 0), (deep, 0.0014), (0, BRICK), (-deep, BRICK)], -half, half)
        m.at(g.moved(0, 0, -STUD / 2))
        _studs(m, columns, 1, BRICK)
        return m.at()
    return make


def slope_inverted_2x2():
    """The underside rises towards its front."""
    m = Model("slope_inverted_2x2").of(PLASTIC)
    deep = STUD - GAP
    _along_x(m).extruded([(-deep, 0), (0, 0), (deep, BRICK - 0.0014), (deep, BRICK), (-deep, BRICK)], -deep, deep)
    _studs(m.at(), 2, 2, BRICK)
    return m


def ridge_2x2():
    """A roof's ridge, from left to right."""
    m = Model("ridge_2x2").of(PLASTIC)
    deep = STUD - GAP
    return _along_x(m).extruded([(-deep, 0), (deep, 0), (deep, 0.0012), (0, BRICK), (-deep, 0.0012)], -deep, deep).at()


def round_brick_2x2():
    m = Model("round_brick_2x2", "none").of(PLASTIC)
    m.turned(0, 0, [(STUD - GAP, 0), (STUD - GAP, BRICK)], 28)
    _studs(m, 2, 2, BRICK)
    return m


def round_brick_1x1():
    m = Model("round_brick_1x1", "none").of(PLASTIC)
    m.turned(0, 0, [(0.0034, 0), (0.0034, 0.0012), (0.0039, 0.0014), (0.0039, BRICK)], 20)
    _studs(m, 1, 1, BRICK)
    return m


def cone_1x1():
    m = Model("cone_1x1", "none").of(PLASTIC)
    return m.turned(0, 0, [(0.0038, 0), (0.0038, 0.002), (0.0024, BRICK), (0.0024, BRICK + 0.0017)], 20)


def cockpit_2x4():
    """A pilot's place: two wide and four deep, two bricks high, a windscreen towards its front."""
    m = Model("cockpit_2x4").of(PLASTIC)
    half, back, front = STUD - GAP, -2 * STUD + GAP, 2 * STUD - GAP
    m.soft_block((-half, 0, back), (half, PLATE, front), BEVEL)
    for s in (-1, 1):
        x0, x1 = sorted((s * half, s * (half - 0.0012)))
        m.block((x0, PLATE, back), (x1, 0.0064, front))
    m.block((-half, PLATE, back), (half, 2 * BRICK - PLATE, back + 0.003))
    m.soft_block((-half, 2 * BRICK - PLATE, back), (half, 2 * BRICK, back + STUD - 0.0002), BEVEL)
    m.at(g.moved(0, 0, -1.5 * STUD))
    _studs(m, 2, 1, 2 * BRICK)
    m.at().of(DARK).soft_block((-0.004, PLATE, -0.006), (0.004, 0.0052, 0.002), BEVEL)
    m.soft_block((-0.004, PLATE, -0.0095), (0.004, 0.0125, -0.006), BEVEL)
    m.block((-half + 0.0012, PLATE, 0.0085), (half - 0.0012, 0.0075, front - 0.003))
    m.of(Surface("pilot", (0.93, 0.80, 0.30), 0.4)).turned(0, -0.002, [(0.003, 0.005), (0.0034, 0.0095), (0.0024, 0.011)], 12)
    m.of(Surface("helmet", (0.93, 0.93, 0.92), 0.3)).ball(0, 0.0132, -0.002, 0.0033, 12, 8)
    m.of(CLEAR)
    outline = [(back + STUD, 0.0065), (front, 0.0065), (front - 0.002, 0.0085), (0.0035, 2 * BRICK - 0.0005), (back + STUD, 2 * BRICK - 0.0005)]
    return _along_x(m).extruded(outline, -half + 0.0001, half - 0.0001).at()


def canopy_2x2():
    """A window on a slope."""
    m = Model("canopy_2x2").of(CLEAR)
    deep = STUD - GAP
    _along_x(m).extruded([(-deep, 0), (deep, 0), (deep, 0.0014), (0, BRICK), (-deep, BRICK)], -deep, deep)
    m.at(g.moved(0, 0, -STUD / 2))
    _studs(m, 2, 1, BRICK)
    return m.at()


def engine_2x2():
    """Blows towards its back."""
    m = Model("engine_2x2").of(GREY)
    _body(m, 2, 1, BRICK)
    m.at(g.turned_x(-90), g.moved(0, BRICK / 2, -STUD / 2 + 0.0005))
    m.of(DARK).turned(0, 0, [(0.0034, 0), (0.0036, 0.002), (0.0045, 0.0022), (0.0046, 0.0055), (0.0038, 0.0055), (0.003, 0.004)], 20)
    m.of(GLOWING).turned(0, 0, [(0.0036, 0.0041), (0.002, 0.0046), (0, 0.006)], 16)
    m.at().of(GREY)
    _studs(m, 2, 1, BRICK)
    for s in (-1, 1):
        m.of(DARK).block((s * 0.0062 - 0.0012, 0.002, -0.0045), (s * 0.0062 + 0.0012, 0.0076, 0.0043))
    return m


def _wing(name, side):
    """Four wide and four deep, a plate high; its outer front corner is cut off."""
    m = Model(name).of(PLASTIC)
    half = 2 * STUD - GAP
    (x0, z0), (x1, z1) = (-half, -STUD + 0.001), (STUD + 0.001, half - 0.0002)   # the cut
    outline = [(side * x, z) for x, z in ((-half, -half), (half, -half), (half, z1), (x1, z1), (x0, z0))]
    # An outline over the ground: its second number runs towards the front.
    m.at(g.turned_x(90), g.moved(0, PLATE, 0)).extruded(outline, 0, PLATE)

    def is_off(i, k):
        x, z = (i - 1.5) * STUD, (k - 1.5) * STUD
        beyond = (x1 - x0) * (z - z0) - (z1 - z0) * (x - x0)
        return beyond / math.dist((x0, z0), (x1, z1)) > -0.0026

    off = [(i if side > 0 else 3 - i, k) for i in range(4) for k in range(4) if is_off(i, k)]
    _studs(m.at(), 4, 4, PLATE, off)
    return m


def wing_left():
    """Stands at the left of a hull whose front is looked at: its straight edge is at its right."""
    return _wing("wing_left", 1)


def wing_right():
    return _wing("wing_right", -1)


def tail_fin():
    """Upright, along the depth."""
    m = Model("tail_fin").of(PLASTIC)
    _body(m, 1, 2, PLATE)
    outline = [(-0.0078, PLATE), (0.0078, PLATE), (0.002, PLATE + 0.004), (-0.0045, 0.021), (-0.0095, 0.021)]
    return _along_x(m).extruded(outline, -0.0016, 0.0016).at()


def antenna():
    m = Model("antenna", "none").of(GREY)
    return m.turned(0, 0, [(0.0036, 0), (0.0036, 0.0012), (0.0012, 0.0035), (0.001, 0.024), (0.0015, 0.0245), (0, 0.026)], 12)


def dish_2x2():
    """A round radar dish."""
    m = Model("dish_2x2", "none").of(GREY)
    return m.turned(0, 0, [(0.0024, 0), (0.0024, 0.0016), (0.0045, 0.002), (0.0079, 0.0045), (0.0074, 0.0045), (0.004, 0.0025), (0, 0.0022)], 24)


def window_brick_2x1():
    m = Model("window_brick_2x1").of(Surface("window frame", (0.93, 0.93, 0.91), 0.3))
    half, deep, high = STUD - GAP, STUD / 2 - GAP, 2 * BRICK
    for s in (-1, 1):
        m.block((s * (half - 0.0005) - 0.0005, 0, -deep), (s * (half - 0.0005) + 0.0005, high, deep))
    m.block((-half + 0.001, 0, -deep), (half - 0.001, 0.0014, deep)).block((-half + 0.001, high - 0.0014, -deep), (half - 0.001, high, deep))
    m.block((-0.0004, 0.0014, 0.0005), (0.0004, high - 0.0014, 0.0025)).block((-half + 0.001, 0.009, 0.0005), (half - 0.001, 0.0098, 0.0025))
    _studs(m, 2, 1, high)
    return m.of(CLEAR).block((-half + 0.0007, 0.0011, -0.0008), (half - 0.0007, high - 0.0011, 0.0007))


def door_brick_3x1():
    """Three wide, five bricks high."""
    m = Model("door_brick_3x1").of(Surface("door", (0.55, 0.33, 0.20), 0.4))
    half, deep, high = 1.5 * STUD - GAP, STUD / 2 - GAP, 5 * BRICK
    m.soft_block((-half + 0.0014, 0.0005, -0.001), (half - 0.0014, high - 0.0016, 0.0015), BEVEL)
    for y in (0.006, 0.027):
        m.soft_block((-0.007, y, 0.0015), (0.007, y + 0.016, 0.0022), BEVEL)
    m.ball(0.008, 0.024, 0.0026, 0.001, 8, 5)
    m.of(Surface("window frame", (0.93, 0.93, 0.91), 0.3))
    for s in (-1, 1):
        m.block((s * (half - 0.0007) - 0.0007, 0, -deep), (s * (half - 0.0007) + 0.0007, high, deep))
    m.block((-half, high - 0.0016, -deep), (half, high, deep))
    _studs(m, 3, 1, high)
    return m


MODELS = (*(brick(*size) for size in ((1, 1), (2, 1), (3, 1), (4, 1), (6, 1), (2, 2), (3, 2), (4, 2), (6, 2))),
          *(plate(*size) for size in ((1, 1), (2, 1), (4, 1), (2, 2), (3, 2), (4, 2), (6, 2), (4, 4), (8, 4), (8, 6))),
          *(tile(*size) for size in ((1, 1), (2, 1), (2, 2), (4, 2))),
          *(slope(columns) for columns in (1, 2, 4)), slope_inverted_2x2, ridge_2x2, round_brick_1x1, round_brick_2x2,
          cone_1x1, cockpit_2x4, canopy_2x2, engine_2x2, wing_left, wing_right, tail_fin, antenna, dish_2x2,
          window_brick_2x1, door_brick_3x1)
