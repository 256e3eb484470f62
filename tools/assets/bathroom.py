"""Furniture of bathrooms."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)


def _bowl(model, cx, cz, rings, stretch):
    """A turned solid made longer towards the front."""
    model.at(g.scaled(1, 1, stretch), g.moved(cx, 0, cz)).turned(0, 0, rings, 24).at()


def toilet():
    t = Model("toilet")
    t.of(PORCELAIN)
    _bowl(t, 0, 0.08, [(0.11, 0), (0.1, 0.06), (0.1, 0.2), (0.17, 0.34), (0.18, 0.4)], 1.35)
    t.soft_block((-0.1, 0, -0.2), (0.1, 0.36, 0.0), 0.02)
    t.soft_block((-0.19, 0.4, -0.34), (0.19, 0.8, -0.17), 0.025).soft_block((-0.2, 0.79, -0.35), (0.2, 0.825, -0.16), 0.01)
    t.soft_block((-0.17, 0.3, -0.3), (0.17, 0.42, -0.08), 0.02)
    t.of(WHITE)
    _bowl(t, 0, 0.08, [(0.185, 0.4), (0.19, 0.41), (0.188, 0.43), (0.17, 0.44)], 1.35)
    return t.of(CHROME).turned(0, -0.255, [(0.03, 0.825), (0.03, 0.835)], 14)


def washbasin():
    """On a cabinet of its own, its back to a wall, with a mirror above it."""
    w = Model("washbasin")
    w.of(WHITE).soft_block((-0.38, 0.3, -0.23), (0.38, 0.78, 0.21), 0.008)
    for s in SIDES:
        w.soft_block((s * 0.19 - 0.185, 0.31, 0.21), (s * 0.19 + 0.185, 0.77, 0.228), 0.006)
        w.of(CHROME).block((s * 0.03 - 0.006, 0.58, 0.228), (s * 0.03 + 0.006, 0.72, 0.245)).of(WHITE)
    w.of(PORCELAIN).soft_block((-0.4, 0.78, -0.24), (0.4, 0.84, 0.25), 0.012)
    _bowl(w, 0, 0.04, [(0.2, 0.84), (0.225, 0.9), (0.2, 0.895), (0.12, 0.85), (0, 0.845)], 0.8)
    w.of(CHROME).turned(0, -0.18, [(0.022, 0.84), (0.02, 1.0)], 10).rod((0, 0.99, -0.18), (0, 0.97, -0.04), 0.014, 8)
    w.of(WALNUT).soft_block((-0.4, 1.15, -0.24), (0.4, 1.95, -0.22), 0.006)
    return w.of(Surface("mirror", (0.80, 0.86, 0.89), 0.05, 0.2)).block((-0.37, 1.18, -0.22), (0.37, 1.92, -0.216))


def bathtub():
    b = Model("bathtub")
    b.of(PORCELAIN).block((-0.85, 0, -0.375), (-0.8, 0.55, 0.375)).block((0.8, 0, -0.375), (0.85, 0.55, 0.375))
    for s in SIDES:
        b.block((-0.8, 0, s * 0.36 - 0.015), (0.8, 0.55, s * 0.36 + 0.015))
        b.soft_block((-0.87, 0.53, s * 0.345 - 0.05), (0.87, 0.58, s * 0.345 + 0.05), 0.012)
        b.soft_block((s * 0.81 - 0.06, 0.53, -0.395), (s * 0.81 + 0.06, 0.58, 0.395), 0.012)
    b.block((-0.8, 0.12, -0.35), (0.8, 0.16, 0.35))
    b.of(WATER).block((-0.8, 0.16, -0.345), (0.8, 0.38, 0.345))
    b.of(CHROME).rod((-0.79, 0.58, 0), (-0.79, 0.68, 0), 0.02, 10).rod((-0.79, 0.67, 0), (-0.65, 0.65, 0), 0.018, 10)
    for s in SIDES:
        b.turned(-0.8, s * 0.1, [(0.025, 0.58), (0.02, 0.63)], 10)
    return b


def shower():
    s = Model("shower")
    s.of(PORCELAIN).soft_block((-0.45, 0, -0.45), (0.45, 0.06, 0.45), 0.012)
    s.of(DARK).turned(0, 0, [(0.06, 0.06), (0.06, 0.064)], 16)
    s.of(CHROME)
    for x, z in ((-0.435, 0.435), (0.435, 0.435), (0.435, -0.435)):
        s.block((x - 0.012, 0.06, z - 0.012), (x + 0.012, 2.0, z + 0.012))
    s.block((-0.447, 1.98, 0.423), (0.447, 2.0, 0.447)).block((0.423, 1.98, -0.447), (0.447, 2.0, 0.423))
    s.rod((-0.2, 0.9, -0.43), (-0.2, 1.95, -0.43), 0.012, 8).rod((-0.2, 1.95, -0.43), (-0.2, 1.95, -0.2), 0.012, 8)
    s.turned(-0.2, -0.2, [(0.1, 1.92), (0.1, 1.935), (0.02, 1.96)], 16)
    s.block((-0.26, 1.0, -0.44), (-0.14, 1.05, -0.4)).rod((0.12, 0.95, 0.46), (0.12, 1.15, 0.46), 0.01, 6)
    return s.of(GLASS).block((-0.423, 0.06, 0.431), (0.423, 1.98, 0.439)).block((0.431, 0.06, -0.423), (0.439, 1.98, 0.423))


def washing_machine():
    w = Model("washing_machine")
    w.of(ENAMEL).soft_block((-0.3, 0.02, -0.3), (0.3, 0.85, 0.28), 0.012)
    w.soft_block((-0.3, 0.7, 0.27), (0.3, 0.85, 0.3), 0.008)
    w.at(g.turned_x(90), g.moved(0, 0.38, 0.28))
    w.of(CHROME).turned(0, 0, [(0.2, 0), (0.2, 0.02), (0.165, 0.03)], 28)
    w.of(SCREEN).turned(0, 0, [(0.165, 0.028), (0.1, 0.045), (0, 0.05)], 28)
    w.at(g.turned_x(90), g.moved(0.02, 0.775, 0.3)).of(CHROME).turned(0, 0, [(0.04, 0), (0.035, 0.025)], 18)
    w.at().of(DARK).block((0.12, 0.74, 0.3), (0.25, 0.81, 0.303)).soft_block((-0.26, 0.73, 0.3), (-0.08, 0.82, 0.306), 0.002)
    return w.of(BLACK).legs(0.5, 0.5, 0.02, 0.05, 0.05)


def towel_rail():
    t = Model("towel_rail")
    t.of(CHROME)
    for s in SIDES:
        t.rod((s * 0.25, 0.3, 0), (s * 0.25, 1.5, 0), 0.016, 8)
    for i in range(9):
        t.rod((-0.25, 0.36 + i * 0.135, 0), (0.25, 0.36 + i * 0.135, 0), 0.01, 6)
    t.of(Surface("towel", (0.55, 0.68, 0.70), 1)).soft_block((-0.2, 0.95, 0.012), (0.16, 1.46, 0.035), 0.008)
    return t.soft_block((-0.2, 1.1, -0.035), (0.16, 1.46, -0.012), 0.008).soft_block((-0.2, 1.44, -0.035), (0.16, 1.47, 0.035), 0.008)


MODELS = (toilet, washbasin, bathtub, shower, washing_machine, towel_rail)
