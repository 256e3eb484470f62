"""Streets, and what stands along them. A street's tile is ten metres square."""
import math

import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
PAVEMENT = Surface("pavement", (0.74, 0.73, 0.70), 0.95)
KERB = Surface("kerb", (0.60, 0.59, 0.57), 0.95)
CLAY = Surface("brickwork", (0.58, 0.34, 0.27), 0.95)
CAR = Surface("car paint", (0.70, 0.18, 0.16), 0.25, 0.2)
WINDSCREEN = Surface("windscreen", (0.12, 0.16, 0.20), 0.08)
LIGHT = Surface("head light", (0.98, 0.96, 0.86), 0.2, 0, 0.4)
TAIL = Surface("tail light", (0.72, 0.08, 0.08), 0.3, 0, 0.3)


# ---- roadways: 6 m of asphalt between two pavements of 2 m

def _roadway(model, low, high):
    model.of(ASPHALT).block((low[0], 0, low[1]), (high[0], 0.05, high[1]))


def _pavement(model, low, high):
    model.of(PAVEMENT).block((low[0], 0, low[1]), (high[0], 0.17, high[1]))


def _kerb(model, low, high):
    model.of(KERB).block((low[0], 0, low[1]), (high[0], 0.18, high[1]))


def _dashes(model, along_x, start, end):
    model.of(MARKING)
    for i in range(3):
        a = start + (end - start) * (i + 0.2) / 3
        b = start + (end - start) * (i + 0.7) / 3
        low, high = ((a, -0.08), (b, 0.08)) if along_x else ((-0.08, a), (0.08, b))
        model.block((low[0], 0.05, low[1]), (high[0], 0.055, high[1]))


def _side(model, turn, length=5):
    """A pavement along the side x = 3..5, turned about the centre."""
    model.at(g.turned_y(turn))
    _pavement(model, (3.15, -length), (5, length))
    _kerb(model, (3, -length), (3.15, length))
    model.at()


def _corner(model, turn):
    """The corner of a pavement between two streets that meet."""
    model.at(g.turned_y(turn))
    _pavement(model, (3.15, 3.15), (5, 5))
    _kerb(model, (3, 3), (3.15, 5))
    _kerb(model, (3.15, 3), (5, 3.15))
    model.at()


def street():
    """Straight, from its front to its back."""
    m = Model("street")
    _roadway(m, (-3, -5), (3, 5))
    _side(m, 0)
    _side(m, 180)
    _dashes(m, False, -5, 5)
    return m


def street_corner():
    """From its front to its right."""
    m = Model("street_corner")
    _roadway(m, (-3, -3), (5, 3))
    _roadway(m, (-3, 3), (3, 5))
    _side(m, 180)
    _side(m, 90)
    _corner(m, 0)
    return m


def street_tee():
    """From its left to its right, with a street to its front."""
    m = Model("street_tee")
    _roadway(m, (-5, -3), (5, 3))
    _roadway(m, (-3, 3), (3, 5))
    _side(m, 90)
    _corner(m, 0)
    _corner(m, -90)
    return m


def street_crossing():
    m = Model("street_crossing")
    _roadway(m, (-5, -3), (5, 3))
    for s in SIDES:
        _roadway(m, (-3, min(3 * s, 5 * s)), (3, max(3 * s, 5 * s)))
    for turn in (0, 90, 180, 270):
        _corner(m, turn)
        m.at(g.turned_y(turn)).of(MARKING)
        for i in range(6):
            m.block((-2.6 + i, 0.05, 3.4), (-2.1 + i, 0.055, 4.7))
        m.at()
    return m


def street_end():
    """From its front, where one turns round."""
    m = Model("street_end")
    _roadway(m, (-3, -3), (3, 5))
    _side(m, 0)
    _side(m, 180)
    m.of(PAVEMENT).block((-3, 0, -5), (3, 0.17, -3.15))
    _kerb(m, (-3, -3.15), (3, -3))
    return m


def street_with_crosswalk():
    m = street()
    m.name = "street_with_crosswalk"
    m.parts = [part for part in m.parts if part.surface != MARKING]
    m.of(MARKING)
    for i in range(6):
        m.block((-2.6 + i, 0.05, -1.5), (-2.1 + i, 0.055, 1.5))
    return m


def lawn():
    return Model("lawn", "none").of(GRASS).block((-5, 0, -5), (5, 0.15, 5))


def plaza():
    m = Model("plaza", "none").of(PAVEMENT)
    for i in range(5):
        for k in range(5):
            m.soft_block((-5 + i * 2 + 0.02, 0, -5 + k * 2 + 0.02), (-3 + i * 2 - 0.02, 0.17, -3 + k * 2 - 0.02), 0.015)
    return m.of(KERB).block((-5, 0, -5), (5, 0.15, 5))


def parking_space():
    """Cars come in from its front."""
    m = Model("parking_space").of(ASPHALT).block((-1.25, 0, -2.5), (1.25, 0.05, 2.5))
    m.of(MARKING)
    for s in SIDES:
        x0, x1 = sorted((s * 1.25, s * 1.19))
        m.block((x0, 0.05, -2.5), (x1, 0.055, 2.5))
    return m.block((-1.19, 0.05, -2.5), (1.19, 0.055, -2.44))


# ---- vehicles: their hulls are outlines over depth and height, drawn out across

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


# ---- houses

def _windows(model, face, columns, floors, width, height, first, storey, half_width, sill=True, surface=PANE):
    """Windows on the wall z = face, or -z where the face is negative."""
    s = 1 if face > 0 else -1
    for i in range(columns):
        for k in range(floors):
            x = (i - (columns - 1) / 2) * 2 * half_width / columns
            y = first + k * storey
            z0, z1 = sorted((face, face + s * 0.05))
            model.of(WHITE).block((x - width / 2 - 0.08, y - 0.08, z0), (x + width / 2 + 0.08, y + height + 0.08, z1))
            z0, z1 = sorted((face, face + s * 0.07))
            model.of(surface).block((x - width / 2, y, z0), (x - 0.03, y + height, z1)).block((x + 0.03, y, z0), (x + width / 2, y + height, z1))


def _front_door(model, x, face, color, height=2.2):
    model.of(WHITE).block((x - 0.62, 0.1, face), (x + 0.62, height + 0.12, face + 0.06))
    model.of(color).soft_block((x - 0.5, 0.1, face), (x + 0.5, height, face + 0.1), 0.02)
    model.of(BRASS).ball(x + 0.38, 1.15, face + 0.12, 0.05, 8, 5)
    model.of(STONE).block((x - 0.9, 0, face), (x + 0.9, 0.1, face + 0.9))


def _gabled(name, width, depth, eaves, ridge, wall):
    m = Model(name).of(wall)
    m.block((-width / 2, 0, -depth / 2), (width / 2, eaves, depth / 2))
    m.at(g.turned_y(-90)).extruded([(-depth / 2, eaves), (depth / 2, eaves), (0, ridge - 0.15)], -width / 2, width / 2)
    m.of(ROOF)
    rise = (ridge - eaves) / (depth / 2)
    edge = depth / 2 + 0.4
    outline = [(-edge, eaves - 0.4 * rise), (0, ridge), (0, ridge + 0.2), (-edge, eaves - 0.4 * rise + 0.16)]
    for side in SIDES:
        m.extruded([(side * z, y) for z, y in outline], -width / 2 - 0.35, width / 2 + 0.35)
    m.at()
    return m


def house():
    """Of two storeys, with its door at its front."""
    m = _gabled("house", 9, 8, 5.2, 8.4, Surface("rendering", (0.93, 0.87, 0.74), 0.95))
    for face in (4, -4):
        _windows(m, face, 3, 1, 1.3, 1.4, 3.5, 2.7, 4.2)
        _windows(m, face, 2 if face > 0 else 3, 1, 1.5, 1.5, 0.95, 2.7, 4.2)
    for turn in (90, -90):
        m.at(g.turned_y(turn))
        _windows(m, 4.5, 2, 2, 1.2, 1.4, 0.95, 2.6, 3.5)
        m.at()
    _front_door(m, 0, 4, Surface("green door", (0.19, 0.38, 0.30), 0.5))
    m.of(CLAY).soft_block((2.3, 6.2, -1.9), (3.1, 9.3, -1.1), 0.03).block((2.2, 9.2, -2.0), (3.2, 9.4, -1.0))
    return m


def cottage():
    """Of one storey."""
    m = _gabled("cottage", 7, 6, 2.7, 5.4, Surface("whitewash", (0.95, 0.93, 0.88), 0.95))
    for face in (3, -3):
        _windows(m, face, 2, 1, 1.3, 1.2, 1.0, 2.7, 3.9)
    for turn in (90, -90):
        m.at(g.turned_y(turn))
        _windows(m, 3.5, 1, 2, 1.1, 1.1, 1.0, 2.2, 2)
        m.at()
    _front_door(m, 0, 3, Surface("red door", (0.62, 0.20, 0.17), 0.5))
    return m.of(CLAY).soft_block((-2.4, 3.4, -1.6), (-1.7, 6.2, -0.9), 0.03)


def town_house():
    """Of three storeys, to stand in a row."""
    m = Model("town_house").of(CLAY).block((-3, 0, -4.5), (3, 9.4, 4.5))
    m.of(STONE).block((-3.02, 0, -4.52), (3.02, 0.6, 4.54)).soft_block((-3.12, 9.4, -4.62), (3.12, 9.75, 4.72), 0.05)
    m.block((-3.02, 3.15, 4.5), (3.02, 3.3, 4.58))
    _windows(m, 4.5, 3, 2, 1.1, 1.7, 3.9, 2.8, 2.8)
    _windows(m, -4.5, 3, 3, 1.1, 1.5, 1.1, 2.8, 2.8)
    m.of(WHITE).block((-2.3, 0.95, 4.5), (0.1, 2.75, 4.56)).of(PANE).block((-2.2, 1.05, 4.5), (0.0, 2.65, 4.6))
    _front_door(m, 1.6, 4.5, Surface("blue door", (0.18, 0.28, 0.46), 0.5), 2.4)
    return m.of(DARK).block((-2.9, 9.75, -4.4), (2.9, 9.8, 4.4)).of(CLAY).soft_block((-2.6, 9.7, -2), (-1.8, 11.2, -1.2), 0.03)


def shop():
    m = Model("shop").of(Surface("stucco", (0.84, 0.78, 0.68), 0.95)).block((-4, 0, -4.5), (4, 7.2, 4.5))
    m.of(STONE).soft_block((-4.1, 7.2, -4.6), (4.1, 7.5, 4.65), 0.05)
    _windows(m, 4.5, 4, 1, 1.1, 1.6, 4.6, 2.8, 3.7)
    _windows(m, -4.5, 3, 2, 1.1, 1.5, 1.2, 3.2, 3.7)
    m.of(DARK).block((-3.8, 0, 4.5), (3.8, 3.0, 4.56))
    m.of(PANE)
    for x0, x1 in ((-3.6, -1.1), (0.9, 3.6)):
        m.block((x0, 0.5, 4.56), (x1, 2.85, 4.6))
    m.of(WALNUT).soft_block((-0.7, 0.05, 4.56), (0.5, 2.4, 4.62), 0.02).of(PANE).block((-0.5, 0.9, 4.62), (0.3, 2.2, 4.64))
    m.of(Surface("fascia", (0.17, 0.35, 0.32), 0.6)).soft_block((-3.9, 3.05, 4.5), (3.9, 3.75, 4.66), 0.03)
    m.of(BRASS).block((-1.8, 3.3, 4.66), (1.8, 3.5, 4.68))
    for i in range(10):
        m.of(Surface("awning", (0.78, 0.27, 0.22), 0.9) if i % 2 else WHITE)
        x = -3.8 + i * 0.76
        m.at(g.turned_y(-90)).extruded([(4.66, 2.9), (6.0, 2.35), (6.0, 2.42), (4.66, 3.0)], -x - 0.76, -x).at()
    return m


def apartments():
    """A block of flats of six storeys."""
    m = Model("apartments").of(Surface("light render", (0.86, 0.83, 0.78), 0.95)).block((-8, 0, -5.5), (8, 18.6, 5.5))
    m.of(CONCRETE).soft_block((-8.15, 18.6, -5.65), (8.15, 19.0, 5.65), 0.05).block((-8.03, 0, -5.53), (8.03, 0.6, 5.53))
    for face in (5.5, -5.5):
        s = 1 if face > 0 else -1
        m.of(PANE)
        for k in range(6):
            for i in range(6):
                if k == 0 and s > 0 and i in (2, 3):
                    continue
                x = -6.5 + i * 2.6
                z0, z1 = sorted((face, face + s * 0.06))
                m.block((x - 0.7, 1.1 + k * 3, z0), (x + 0.7, 2.7 + k * 3, z1))
    m.of(CONCRETE)
    for k in range(1, 6):
        for x in (-5.2, 5.2):
            m.block((x - 2.0, 0.75 + k * 3, 5.5), (x + 2.0, 0.9 + k * 3, 6.7))
            m.of(GLASS).block((x - 2.0, 0.9 + k * 3, 6.64), (x + 2.0, 1.8 + k * 3, 6.7)).of(CONCRETE)
    m.of(DARK).block((-1.3, 0.1, 5.5), (1.3, 2.6, 5.6)).of(PANE).block((-1.1, 0.2, 5.6), (1.1, 2.4, 5.62))
    return m.of(CONCRETE).block((-2, 2.7, 5.5), (2, 2.9, 7.2)).block((-2, 19, -2), (2, 21.2, 2))


def office_tower():
    """Of fourteen storeys."""
    m = Model("office_tower", "none").of(Surface("curtain wall", (0.36, 0.50, 0.60), 0.12, 0.2)).block((-7, 4, -7), (7, 48, 7))
    m.of(CONCRETE).block((-5.8, 0, -5.8), (5.8, 4, 5.8))
    for k in range(15):
        m.block((-7.1, 3.8 + k * 3.14, -7.1), (7.1, 4.15 + k * 3.14, 7.1))
    m.of(STEEL)
    for turn in (0, 90, 180, 270):
        m.at(g.turned_y(turn))
        for i in range(8):
            m.block((-7.0 + i * 2 - 0.07, 4, 7), (-7.0 + i * 2 + 0.07, 48, 7.14))
        m.of(PANE).block((-4.8, 0.3, 5.8), (4.8, 3.5, 5.88)).of(CONCRETE).block((-6.9, 0, 6.3), (-6.3, 4, 6.9)).of(STEEL)
    m.at().of(CONCRETE).block((-3.5, 48, -3.5), (3.5, 50.5, 3.5))
    return m.of(STEEL).turned(0, 0, [(0.2, 50.5), (0.08, 58)], 8)


def church():
    m = Model("church")
    m.of(STONE).block((-4, 0, -9), (4, 6, 6))
    m.extruded([(-4, 6), (4, 6), (0, 10)], -9, 6)
    m.of(Surface("slates", (0.33, 0.36, 0.41), 0.7))
    for outline in ([(-4.4, 5.6), (0, 10.0), (0, 10.2), (-4.4, 5.85)], [(4.4, 5.6), (4.4, 5.85), (0, 10.2), (0, 10.0)]):
        m.extruded(outline, -9.3, 6.2)
    m.of(STONE).block((-2.2, 0, 5), (2.2, 14, 9.4)).of(Surface("slates", ())).at(g.moved(0, 0, 7.2)).post(0, 0, 14, 4.7, 4.7, 21, 0.1, 0.1)
    m.at().of(BRASS).rod((0, 20.9, 7.2), (0, 22.4, 7.2), 0.06, 6).block((-0.4, 21.7, 7.15), (0.4, 21.8, 7.25))
    m.of(WALNUT).extruded([(-0.9, 0), (0.9, 0), (0.9, 2.2), (0, 3.1), (-0.9, 2.2)], 9.4, 9.46)
    m.of(PANE).extruded([(-0.5, 9.5), (0.5, 9.5), (0.5, 11.5), (0, 12.2), (-0.5, 11.5)], 9.4, 9.45)
    for turn in (90, -90):
        m.at(g.turned_y(turn))
        for i in range(4):
            x = (-7.2 + i * 3.3) * (-1 if turn > 0 else 1)
            m.extruded([(x - 0.5, 1.6), (x + 0.5, 1.6), (x + 0.5, 4), (x, 4.8), (x - 0.5, 4)], 4, 4.05)
    return m.at()


# ---- what grows

def _crown(model, x, z, y, r):
    model.ball(x, y, z, r, 12, 6, 0.9)


def tree():
    t = Model("tree", "none", keeps_proportions=True).of(LEAVES)
    for x, z, y, r in ((0, 0, 3.0, 1.0), (0.55, 0.2, 2.45, 0.65), (-0.5, 0.35, 2.6, 0.7), (-0.1, -0.55, 2.5, 0.65)):
        _crown(t, x, z, y, r)
    return t.of(BARK).turned(0, 0, [(0.2, 0), (0.14, 0.25), (0.11, 1.6), (0.07, 2.8)], 12)


def tall_tree():
    t = Model("tall_tree", "none", keeps_proportions=True).of(Surface("dark leaves", (0.23, 0.43, 0.22), 0.9))
    for x, z, y, r in ((0, 0, 6.2, 1.7), (1.1, 0.3, 5.0, 1.3), (-1.0, 0.5, 5.1, 1.4), (-0.1, -1.1, 4.9, 1.3), (0.3, 1.0, 4.5, 1.1)):
        _crown(t, x, z, y, r)
    t.of(BARK).turned(0, 0, [(0.42, 0), (0.28, 0.5), (0.22, 3), (0.12, 5.5)], 12)
    return t.rod((0, 2.6, 0), (1.0, 4.4, 0.3), 0.1, 8, 0.05).rod((0, 2.9, 0), (-0.9, 4.5, 0.5), 0.1, 8, 0.05)


def fir_tree():
    t = Model("fir_tree", "none", keeps_proportions=True).of(NEEDLES)
    for y, r, h in ((0.9, 1.35, 1.9), (2.0, 1.1, 1.7), (3.0, 0.85, 1.5), (3.9, 0.58, 1.6)):
        t.turned(0, 0, [(r * 0.25, y + 0.15), (r, y), (0, y + h)], 14)
    return t.of(BARK).turned(0, 0, [(0.18, 0), (0.14, 1.3)], 10)


def hedge():
    h = Model("hedge", "none").of(LEAVES).soft_block((-1, 0, -0.3), (1, 1.0, 0.3), 0.08)
    for i in range(5):
        h.soft_block((-0.96 + i * 0.4, 0.1, -0.33), (-0.64 + i * 0.4, 0.9, 0.33), 0.05)
    return h


def flower_bed():
    f = Model("flower_bed", "none").of(Surface("flowers", (0.88, 0.36, 0.42), 0.9))
    for i in range(4):
        for k in range(3):
            x, z = -0.72 + i * 0.48 + 0.1 * (k % 2), -0.27 + k * 0.27
            f.of(Surface("flowers", ()) if (i + k) % 2 else Surface("yellow flowers", (0.95, 0.79, 0.30), 0.9)).ball(x, 0.34, z, 0.1, 8, 5)
            f.of(LEAVES).turned(x, z, [(0.13, 0.12), (0.1, 0.22), (0.03, 0.32)], 6)
    f.of(SOIL).block((-0.95, 0, -0.45), (0.95, 0.13, 0.45)).of(STONE)
    for s in SIDES:
        f.soft_block((-1, 0, s * 0.475 - 0.025), (1, 0.17, s * 0.475 + 0.025), 0.01).block((s * 0.975 - 0.025, 0, -0.45), (s * 0.975 + 0.025, 0.165, 0.45))
    return f


# ---- street furniture

def street_lamp():
    """Leans out over its front."""
    m = Model("street_lamp", keeps_proportions=True).of(DARK)
    m.turned(0, 0, [(0.16, 0), (0.16, 0.1), (0.09, 0.2), (0.07, 0.9), (0.05, 4.9)], 12)
    m.rod((0, 4.8, 0), (0, 5.2, 0.25), 0.045, 8).rod((0, 5.2, 0.25), (0, 5.25, 1.0), 0.04, 8)
    m.soft_block((-0.11, 5.18, 0.7), (0.11, 5.3, 1.35), 0.03)
    return m.of(Surface("lamp", (1, 0.94, 0.76), 0.4, 0, 0.8)).block((-0.08, 5.165, 0.78), (0.08, 5.18, 1.3))


def traffic_light():
    m = Model("traffic_light", keeps_proportions=True).of(DARK)
    m.turned(0, 0, [(0.12, 0), (0.12, 0.08), (0.05, 0.12), (0.05, 2.5)], 12).soft_block((-0.16, 2.3, -0.1), (0.16, 3.25, 0.12), 0.03)
    for y, name, color in ((3.08, "red light", (0.9, 0.15, 0.12)), (2.78, "amber light", (0.95, 0.65, 0.15)), (2.48, "green light", (0.2, 0.75, 0.3))):
        m.of(Surface(name, color, 0.3, 0, 0.5)).at(g.turned_x(90), g.moved(0, y, 0.12)).turned(0, 0, [(0.1, 0), (0.08, 0.02), (0, 0.03)], 14)
        m.at().of(DARK).soft_block((-0.12, y + 0.1, 0.12), (0.12, y + 0.125, 0.28), 0.005)
    return m


def bench():
    b = Model("bench").of(OAK)
    for i in range(4):
        b.soft_block((-0.8, 0.42, -0.2 + i * 0.11), (0.8, 0.455, -0.11 + i * 0.11), 0.008)
    b.at(g.leaning(14, 0.45, -0.22))
    for i in range(3):
        b.soft_block((-0.8, 0.54 + i * 0.12, -0.25), (0.8, 0.63 + i * 0.12, -0.22), 0.008)
    b.of(DARK)
    for s in SIDES:
        b.at(g.leaning(14, 0.45, -0.22)).block((s * 0.6 - 0.025, 0.4, -0.275), (s * 0.6 + 0.025, 0.86, -0.25))
        b.at().block((s * 0.6 - 0.025, 0.38, -0.24), (s * 0.6 + 0.025, 0.42, 0.22))
        for z in (-0.2, 0.18):
            b.block((s * 0.6 - 0.025, 0, z - 0.025), (s * 0.6 + 0.025, 0.38, z + 0.025))
    return b.at()


def litter_bin():
    b = Model("litter_bin", "none", keeps_proportions=True).of(Surface("bin", (0.22, 0.40, 0.32), 0.6))
    return b.turned(0, 0, [(0.2, 0.05), (0.25, 0.1), (0.25, 0.8), (0.27, 0.82), (0.27, 0.88), (0.2, 0.9)], 18).of(BLACK).turned(
        0, 0, [(0.19, 0.895), (0.19, 0.903)], 16).of(DARK).turned(0, 0, [(0.15, 0), (0.15, 0.06)], 12)


def fence():
    """Two metres of pales."""
    f = Model("fence").of(WHITE)
    for i in range(10):
        x = -0.9 + i * 0.2
        f.extruded([(x - 0.06, 0.05), (x + 0.06, 0.05), (x + 0.06, 0.9), (x, 1.0), (x - 0.06, 0.9)], 0.02, 0.045)
    for y in (0.25, 0.7):
        f.block((-1, y, -0.02), (1, y + 0.08, 0.02))
    for s in SIDES:
        f.soft_block((s * 0.96 - 0.04, 0, -0.04), (s * 0.96 + 0.04, 1.05, 0.02), 0.01)
    return f


def fountain():
    f = Model("fountain", "none", keeps_proportions=True).of(STONE)
    f.turned(0, 0, [(2.0, 0), (2.0, 0.4), (2.1, 0.42), (2.1, 0.55), (1.8, 0.55), (1.8, 0.3)], 32)
    f.turned(0, 0, [(0.5, 0.3), (0.3, 0.5), (0.22, 1.2), (0.9, 1.45), (0.95, 1.6), (0.8, 1.6), (0.6, 1.5)], 24)
    f.turned(0, 0, [(0.15, 1.5), (0.12, 2.0), (0.4, 2.15), (0.42, 2.25), (0.3, 2.22)], 18)
    return f.of(WATER).turned(0, 0, [(1.8, 0.3), (1.8, 0.42)], 32).turned(0, 0, [(0.8, 1.5), (0.8, 1.56)], 24).turned(
        0, 0, [(0.34, 2.15), (0.34, 2.235), (0.05, 2.26), (0.03, 2.6), (0, 2.65)], 14)


def bus_stop():
    b = Model("bus_stop").of(DARK)
    for s in SIDES:
        for z in (-0.7, 0.5):
            b.block((s * 1.9 - 0.04, 0, z - 0.04), (s * 1.9 + 0.04, 2.4, z + 0.04))
    b.soft_block((-2.1, 2.4, -0.85), (2.1, 2.5, 0.75), 0.02)
    b.of(GLASS).block((-1.86, 0.2, -0.72), (1.86, 2.3, -0.7)).block((1.89, 0.2, -0.66), (1.91, 2.3, 0.46))
    b.of(OAK).soft_block((-1.2, 0.42, -0.6), (1.2, 0.47, -0.2), 0.01).of(DARK)
    for s in SIDES:
        b.block((s * 1.0 - 0.03, 0, -0.45), (s * 1.0 + 0.03, 0.42, -0.35))
    return b.of(Surface("sign blue", (0.16, 0.36, 0.66), 0.5)).soft_block((-1.95, 1.8, 0.45), (-1.85, 2.3, 0.95), 0.02)


def person():
    """An adult of 1.75 m, for scale."""
    p = Model("person", keeps_proportions=True)
    p.of(Surface("pullover", (0.72, 0.33, 0.27), 0.95)).turned(0, 0, [(0.15, 0.85), (0.17, 1.1), (0.19, 1.35), (0.08, 1.48)], 14)
    for s in SIDES:
        p.of(Surface("pullover", ())).rod((s * 0.19, 1.4, 0), (s * 0.26, 0.95, 0.03), 0.05, 8)
        p.of(SKIN).ball(s * 0.265, 0.89, 0.04, 0.055, 8, 5)
        p.of(Surface("trousers", (0.24, 0.28, 0.38), 0.9)).rod((s * 0.09, 0.9, 0), (s * 0.1, 0.06, 0), 0.085, 10, 0.06)
        p.of(BARK).soft_block((s * 0.1 - 0.055, 0, -0.1), (s * 0.1 + 0.055, 0.09, 0.18), 0.02)
    p.of(SKIN).turned(0, 0, [(0.05, 1.44), (0.05, 1.54)], 10).ball(0, 1.62, 0, 0.115, 12, 8, 1.12)
    return p.of(Surface("hair", (0.25, 0.17, 0.12), 0.9)).ball(0, 1.655, -0.022, 0.118, 12, 8, 1.0)


MODELS = (street, street_corner, street_tee, street_crossing, street_end, street_with_crosswalk, lawn, plaza,
          parking_space, car, small_car, van, bus, house, cottage, town_house, shop, apartments, office_tower, church,
          tree, tall_tree, fir_tree, hedge, flower_bed, street_lamp, traffic_light, bench, litter_bin, fence, fountain,
          bus_stop, person)
