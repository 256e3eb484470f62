"""Vehicles. Their hulls are outlines over depth and height, drawn out across."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
CAR = Surface("car paint", (0.70, 0.18, 0.16), 0.25, 0.2)
WINDSCREEN = Surface("windscreen", (0.12, 0.16, 0.20), 0.08)
LIGHT = Surface("head light", (0.98, 0.96, 0.86), 0.2, 0, 0.4)
TAIL = Surface("tail light", (0.72, 0.08, 0.08), 0.3, 0, 0.3)


def _along(model):
    return model.at(g.turned_y(-90))


def _wheels(model, half, places, radius=0.32):
    for z in places:
        for s in SIDES:
            model.at(g.turned_z(-90 * s), g.moved(s * (half - 0.2), radius, z))
            model.of(RUBBER).turned(0, 0, [(radius - 0.03, 0), (radius, 0.03), (radius, 0.18), (radius - 0.04, 0.21), (radius * 0.6, 0.21)], 18)
            model.of(STEEL).turned(0, 0, [(radius * 0.6, 0.2), (radius * 0.5, 0.215), (0.05, 0.2), (0, 0.215)], 10)
    model.at()


def _lights(model, half, front, back, y, wide=0.16):
    for s in SIDES:
        x = s * (half - 0.24)
        model.of(LIGHT).soft_block((x - wide, y - 0.06, front - 0.03), (x + wide, y + 0.06, front + 0.012), 0.01)
        model.of(TAIL).soft_block((x - wide, y + 0.02, back - 0.012), (x + wide, y + 0.14, back + 0.03), 0.01)


def _cabin(model, outline, low_half, high_half):
    """A hull that is narrower above, of (z, y) corners."""
    outline = g.counter_clockwise(outline)
    low, high = min(y for _, y in outline), max(y for _, y in outline)

    def corner(side, z, y):
        return (side * (low_half + (high_half - low_half) * (y - low) / (high - low)), y, z)

    n = len(outline)
    for i in range(n):
        (za, ya), (zb, yb) = outline[i], outline[(i + 1) % n]
        model.face([corner(1, za, ya), corner(1, zb, yb), corner(-1, zb, yb), corner(-1, za, ya)])
    for a, b, c in g.triangles_of(outline):
        model.face([corner(1, *outline[k]) for k in (c, b, a)]).face([corner(-1, *outline[k]) for k in (a, b, c)])


def _car(name, hull, cabin, roof, length):
    m = Model(name).of(CAR)
    half = 0.88
    _along(m).extruded(hull, -half, half)
    m.at().of(WINDSCREEN)
    _cabin(m, cabin, half - 0.04, half - 0.2)
    m.of(CAR)
    z0, z1, top = roof
    m.soft_block((-half + 0.19, top - 0.03, z0), (half - 0.19, top + 0.03, z1), 0.025)
    for s in SIDES:  # posts between the windows
        for z in (z0 + 0.05, (z0 + z1) / 2 + 0.05):
            m.rod((s * (half - 0.03), 0.85, z), (s * (half - 0.2), top, z), 0.035, 6)
        m.soft_block((s * (half + 0.05) - 0.07, 0.88, z1 + 0.32), (s * (half + 0.05) + 0.07, 1.0, z1 + 0.42), 0.02)
    _lights(m, half, length / 2 - 0.04, -length / 2 + 0.04, 0.62)
    m.of(DARK).soft_block((-half + 0.02, 0.28, length / 2 - 0.08), (half - 0.02, 0.42, length / 2), 0.03)
    m.soft_block((-half + 0.02, 0.28, -length / 2), (half - 0.02, 0.42, -length / 2 + 0.08), 0.03)
    m.of(WHITE).block((-0.24, 0.45, length / 2 - 0.04), (0.24, 0.55, length / 2 - 0.02)).block((-0.24, 0.45, -length / 2 + 0.02), (0.24, 0.55, -length / 2 + 0.04))
    return m


def car():
    m = _car("car",
             [(-2.06, 0.25), (2.06, 0.25), (2.08, 0.55), (1.98, 0.75), (1.0, 0.9), (-1.6, 0.92), (-2.02, 0.86), (-2.08, 0.6)],
             [(-1.55, 0.9), (1.0, 0.88), (0.35, 1.4), (-1.0, 1.4)], (-1.0, 0.35, 1.42), 4.2)
    _wheels(m, 0.9, (-1.28, 1.3))
    return m


def small_car():
    m = _car("small_car",
             [(-1.7, 0.25), (1.7, 0.25), (1.72, 0.55), (1.6, 0.78), (0.95, 0.9), (-1.55, 0.95), (-1.72, 0.6)],
             [(-1.6, 0.92), (0.95, 0.88), (0.35, 1.45), (-1.25, 1.45)], (-1.25, 0.35, 1.47), 3.5)
    _wheels(m, 0.9, (-1.1, 1.1), 0.3)
    return m


def van():
    m = Model("van").of(Surface("van paint", (0.92, 0.92, 0.90), 0.3, 0.1))
    half = 0.98
    hull = [(-2.55, 0.3), (2.5, 0.3), (2.55, 0.7), (2.4, 1.15), (1.75, 2.05), (1.5, 2.2), (-2.5, 2.2), (-2.58, 1.2)]
    _along(m).extruded(hull, -half, half)
    m.of(WINDSCREEN)
    m.extruded([(2.385, 1.17), (2.4, 1.19), (1.79, 2.03), (1.77, 2.02)], -half + 0.1, half - 0.1)
    for s in SIDES:
        x0, x1 = sorted((s * half, s * (half + 0.012)))
        m.extruded([(1.0, 1.2), (2.15, 1.2), (1.7, 1.9), (1.0, 1.9)], x0, x1)
    m.at()
    for s in SIDES:
        m.block((s * 0.45 - 0.35, 1.35, -2.6), (s * 0.45 + 0.35, 1.9, -2.55))
    m.of(DARK).soft_block((-half, 0.3, 2.48), (half, 0.5, 2.6), 0.04).soft_block((-half, 0.3, -2.66), (half, 0.5, -2.54), 0.04)
    for s in SIDES:
        m.soft_block((s * (half + 0.06) - 0.06, 1.25, 1.9), (s * (half + 0.06) + 0.06, 1.5, 2.0), 0.02)
    _lights(m, half, 2.55, -2.6, 0.75)
    _wheels(m, 1.0, (-1.6, 1.65), 0.36)
    return m


def bus():
    m = Model("bus").of(Surface("bus paint", (0.87, 0.68, 0.20), 0.35, 0.1))
    half = 1.25
    _along(m).extruded([(-5.95, 0.35), (5.95, 0.35), (6.0, 1.0), (5.9, 2.9), (5.7, 3.05), (-5.85, 3.05), (-6.0, 2.9)], -half, half)
    m.at().of(WINDSCREEN).block((-half + 0.12, 1.15, 5.9), (half - 0.12, 2.6, 6.0)).block((-half + 0.2, 1.6, -6.01), (half - 0.2, 2.6, -5.95))
    for s in SIDES:
        x0, x1 = sorted((s * half, s * (half + 0.012)))
        for i in range(7):
            m.block((x0, 1.35, -5.6 + i * 1.55), (x1, 2.55, -4.15 + i * 1.55))
    for z in (4.6, -0.6):   # its doors are at its right
        m.block((-half - 0.016, 0.45, z), (-half, 2.55, z + 1.1))
        m.of(DARK).block((-half - 0.02, 0.45, z + 0.53), (-half, 2.55, z + 0.57)).of(WINDSCREEN)
    m.of(DARK).soft_block((-half, 0.35, 5.9), (half, 0.6, 6.05), 0.04)
    m.of(Surface("sign", (0.98, 0.76, 0.25), 0.5, 0, 0.6)).block((-0.8, 2.66, 5.93), (0.8, 2.86, 5.99))
    _lights(m, half, 6.0, -6.0, 0.8, 0.2)
    _wheels(m, 1.25, (-3.4, 3.5), 0.48)
    return m


MODELS = (car, small_car, van, bus)
