"""Houses, their doors at their fronts."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
CLAY = Surface("brickwork", (0.58, 0.34, 0.27), 0.95)


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


def corner_shop():
    m = Model("corner_shop").of(Surface("stucco", (0.84, 0.78, 0.68), 0.95)).block((-4, 0, -4.5), (4, 7.2, 4.5))
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


MODELS = (house, cottage, town_house, corner_shop, apartments, office_tower, church)
