"""Furniture of bedrooms."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
BLANKET = Surface("blanket", (0.34, 0.45, 0.56), 1)


def _bed(name, half, pillows):
    b = Model(name)
    b.of(BLANKET).soft_block((-half + 0.01, 0.33, -0.35), (half - 0.01, 0.54, 1.02), 0.045)
    b.of(OAK).soft_block((-half, 0.1, -1.0), (half, 0.32, 1.05), 0.015)
    b.soft_block((-half, 0, -1.05), (half, 1.0, -1.0), 0.012)
    for s in SIDES:
        b.block((s * (half - 0.08) - 0.035, 0, 0.93), (s * (half - 0.08) + 0.035, 0.1, 1.0))
    b.of(LINEN).soft_block((-half + 0.03, 0.3, -0.99), (half - 0.03, 0.5, 1.0), 0.04)
    b.at(g.leaning(6, 0.5, -0.94))
    for x in pillows:
        b.soft_block((x - 0.32, 0.49, -0.94), (x + 0.32, 0.62, -0.52), 0.05)
    return b


def bed():
    return _bed("bed", 0.8, (-0.38, 0.38))


def single_bed():
    return _bed("single_bed", 0.48, (0,))


def wardrobe():
    w = Model("wardrobe")
    w.of(OAK).soft_block((-0.75, 0.06, -0.3), (0.75, 2.1, 0.27), 0.008)
    for i in range(3):
        x = -0.5 + i * 0.5
        w.of(WHITE).soft_block((x - 0.244, 0.08, 0.27), (x + 0.244, 2.08, 0.292), 0.006)
        w.of(DARK).block((x + (0.2 if i == 0 else -0.21), 1.0, 0.292), (x + (0.212 if i == 0 else -0.198), 1.24, 0.315))
    return w.of(DARK).block((-0.72, 0, -0.28), (0.72, 0.06, 0.24))


def nightstand():
    n = Model("nightstand")
    n.of(OAK).soft_block((-0.24, 0.14, -0.2), (0.24, 0.5, 0.19), 0.008)
    n.of(WHITE).soft_block((-0.225, 0.16, 0.19), (0.225, 0.32, 0.205), 0.005).soft_block((-0.225, 0.33, 0.19), (0.225, 0.485, 0.205), 0.005)
    n.of(DARK).block((-0.05, 0.4, 0.205), (0.05, 0.412, 0.225)).block((-0.05, 0.24, 0.205), (0.05, 0.252, 0.225))
    n.legs(0.4, 0.32, 0.14, 0.04, 0.025)
    n.of(BRASS).turned(-0.06, -0.03, [(0.07, 0.5), (0.07, 0.515), (0.012, 0.53), (0.012, 0.7)], 14)
    return n.of(Surface("shade", (0.98, 0.90, 0.74), 0.9, 0, 0.35)).turned(-0.06, -0.03, [(0.12, 0.68), (0.08, 0.86)], 18)


def dresser():
    d = Model("dresser")
    d.of(OAK).soft_block((-0.5, 0.1, -0.24), (0.5, 0.82, 0.22), 0.008).soft_block((-0.52, 0.82, -0.25), (0.52, 0.85, 0.25), 0.006)
    for row in range(3):
        for s in SIDES:
            y = 0.12 + row * 0.232
            d.of(WHITE).soft_block((s * 0.247 - 0.24, y, 0.22), (s * 0.247 + 0.24, y + 0.222, 0.238), 0.005)
            d.of(BRASS).ball(s * 0.247, y + 0.12, 0.25, 0.018, 8, 5)
    return d.of(WALNUT).legs(0.9, 0.36, 0.1, 0.05, 0.035)


def standing_mirror():
    m = Model("standing_mirror")
    m.at(g.leaning(8, 0, 0)).of(WALNUT)
    for s in SIDES:
        m.soft_block((s * 0.26 - 0.03, 0.02, -0.02), (s * 0.26 + 0.03, 1.7, 0.02), 0.008)
    for y in (0.08, 1.64):
        m.soft_block((-0.23, y, -0.02), (0.23, y + 0.06, 0.02), 0.008)
    m.of(Surface("mirror", (0.80, 0.86, 0.89), 0.05, 0.2)).block((-0.23, 0.14, -0.005), (0.23, 1.64, 0.008))
    return m.at().of(WALNUT).rod((0, 1.2, -0.19), (0, 0.02, -0.5), 0.02, 8)


def toy_chest():
    t = Model("toy_chest")
    t.of(PINE).soft_block((-0.4, 0.03, -0.22), (0.4, 0.4, 0.22), 0.01).soft_block((-0.42, 0.4, -0.24), (0.42, 0.46, 0.24), 0.012)
    colors = (Surface("red paint", (0.80, 0.28, 0.24), 0.5), Surface("blue paint", (0.27, 0.47, 0.70), 0.5),
              Surface("yellow paint", (0.94, 0.76, 0.28), 0.5))
    for i, color in enumerate(colors):
        t.of(color).at(g.turned_x(90), g.moved(-0.24 + 0.24 * i, 0.22, 0.22)).turned(0, 0, [(0.085, 0), (0.08, 0.008)], 20)
    return t.at().of(DARK).legs(0.7, 0.36, 0.03, 0.05, 0.05)


MODELS = (bed, single_bed, wardrobe, nightstand, dresser, standing_mirror, toy_chest)
