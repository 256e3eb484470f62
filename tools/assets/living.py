"""Furniture of living rooms."""
import math

import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)


def table():
    t = Model("table", "none")
    t.of(OAK).soft_block((-0.7, 0.705, -0.4), (0.7, 0.74, 0.4), 0.008)
    t.of(WALNUT).legs(1.28, 0.68, 0.705, 0.065, 0.045)
    for s in SIDES:
        t.block((-0.61, 0.62, s * 0.34 - 0.01), (0.61, 0.705, s * 0.34 + 0.01))
        t.block((s * 0.64 - 0.01, 0.62, -0.31), (s * 0.64 + 0.01, 0.705, 0.31))
    return t


def round_table():
    t = Model("round_table", "none")
    t.of(OAK).turned(0, 0, [(0.54, 0.705), (0.55, 0.712), (0.55, 0.735), (0.545, 0.74)], 40)
    t.of(WALNUT).turned(0, 0, [(0.3, 0), (0.3, 0.02), (0.06, 0.07), (0.045, 0.2), (0.045, 0.6), (0.09, 0.705)], 24)
    return t


def coffee_table():
    t = Model("coffee_table", "none")
    t.of(WALNUT).soft_block((-0.55, 0.38, -0.3), (0.55, 0.42, 0.3), 0.01)
    t.of(OAK).legs(0.98, 0.48, 0.38, 0.045, 0.03, 0.015)
    t.block((-0.48, 0.14, -0.22), (0.48, 0.16, 0.22))
    t.of(Surface("paper", (0.88, 0.83, 0.70), 0.9)).block((-0.3, 0.16, -0.12), (-0.08, 0.19, 0.16))
    t.of(Surface("vase", (0.35, 0.52, 0.55), 0.4)).turned(
        0.25, 0, [(0.04, 0.42), (0.065, 0.47), (0.05, 0.53), (0.025, 0.57), (0.035, 0.6)], 16)
    return t


def chair():
    c = Model("chair")
    c.of(BIRCH).soft_block((-0.22, 0.43, -0.2), (0.22, 0.465, 0.23), 0.012)
    c.legs(0.38, 0.36, 0.43, 0.04, 0.03, 0.01)
    c.at(g.leaning(8, 0.46, -0.19))
    for s in SIDES:
        c.block((s * 0.195 - 0.018, 0.44, -0.205), (s * 0.195 + 0.018, 0.86, -0.17))
    c.soft_block((-0.22, 0.74, -0.21), (0.22, 0.87, -0.175), 0.01)
    for y in (0.56, 0.65):
        c.block((-0.18, y, -0.2), (0.18, y + 0.035, -0.182))
    c.at().of(GREY).soft_block((-0.2, 0.465, -0.165), (0.2, 0.495, 0.21), 0.014)
    return c


def _upholstered(name, width, cushions):
    s = Model(name)
    arm = 0.16
    inner = width - 2 * arm
    each = inner / cushions
    s.of(GREY).soft_block((-width / 2 + 0.02, 0.1, -0.42), (width / 2 - 0.02, 0.3, 0.42), 0.02)
    s.soft_block((-width / 2 + 0.04, 0.2, -0.45), (width / 2 - 0.04, 0.8, -0.24), 0.05)
    for side in SIDES:
        x = side * (width / 2 - arm / 2)
        s.soft_block((x - arm / 2, 0.1, -0.44), (x + arm / 2, 0.6, 0.45), 0.045)
    for i in range(cushions):
        x = -inner / 2 + each * i
        s.at().soft_block((x + 0.005, 0.3, -0.24), (x + each - 0.005, 0.44, 0.44), 0.04)
        s.at(g.leaning(10, 0.4, -0.2)).soft_block((x + 0.015, 0.42, -0.22), (x + each - 0.015, 0.78, -0.08), 0.05)
    s.at().of(WALNUT)
    for x in SIDES:
        for z in SIDES:
            s.post(x * (width / 2 - 0.1), z * 0.36, 0, 0.035, 0.035, 0.1, 0.05, 0.05)
    return s


def sofa():
    return _upholstered("sofa", 2.0, 3)


def armchair():
    return _upholstered("armchair", 0.9, 1)


def stool():
    s = Model("stool", "none")
    s.of(BIRCH).turned(0, 0, [(0.17, 0.43), (0.19, 0.44), (0.19, 0.46), (0.18, 0.47)], 24)
    s.of(WALNUT).legs(0.26, 0.26, 0.435, 0.04, 0.03, 0.03)
    for k in SIDES:
        s.block((-0.11, 0.16, k * 0.12 - 0.008), (0.11, 0.185, k * 0.12 + 0.008))
        s.block((k * 0.12 - 0.008, 0.2, -0.11), (k * 0.12 + 0.008, 0.225, 0.11))
    return s


def bookcase():
    b = Model("bookcase")
    w, depth, height, shelves = 0.45, 0.16, 1.9, 6
    b.of(OAK)
    for s in SIDES:
        b.block((s * w - (0.025 if s > 0 else 0), 0, -depth), (s * w + (0.025 if s < 0 else 0), height, depth))
    b.block((-w + 0.025, 0, -depth), (w - 0.025, height, -depth + 0.012))
    for i in range(shelves):
        y = height - 0.025 if i == shelves - 1 else 0.06 + i * (height - 0.085) / (shelves - 1)
        b.block((-w + 0.025, y, -depth + 0.012), (w - 0.025, y + 0.025, depth - 0.005))
    covers = (Surface("red book", (0.66, 0.25, 0.20), 0.8), Surface("blue book", (0.22, 0.36, 0.52), 0.8),
              Surface("paper", (0.88, 0.83, 0.70), 0.9))
    for shelf in range(shelves - 1):
        y, x, book = 0.085 + shelf * (height - 0.085) / (shelves - 1), -w + 0.035, 0
        while x < w - 0.07 - 0.09 * ((shelf * 3) % 4):
            kind = (book * 7 + shelf * 5) % 11  # any fixed order that looks like none
            thick, tall, out = 0.025 + 0.004 * (kind % 5), 0.2 + 0.014 * (kind % 6), 0.1 + 0.01 * (kind % 4)
            b.of(covers[kind % 3]).block((x, y, -depth + 0.02), (x + thick, y + tall, out - 0.01))
            x, book = x + thick + 0.002, book + 1
    return b


def cabinet():
    c = Model("cabinet")
    c.of(OAK).block((-0.4, 0.08, -0.22), (0.4, 1.08, 0.195))
    c.soft_block((-0.41, 1.08, -0.225), (0.41, 1.105, 0.225), 0.006)
    c.of(WHITE)
    for s in SIDES:
        c.soft_block((s * 0.1985 - 0.1945, 0.095, 0.195), (s * 0.1985 + 0.1945, 1.065, 0.215), 0.005)
    c.of(DARK)
    for s in SIDES:
        c.block((s * 0.035 - 0.007, 0.5, 0.215), (s * 0.035 + 0.007, 0.68, 0.235))
    c.block((-0.38, 0, -0.2), (0.38, 0.08, 0.17))
    return c


def tv():
    """A television on a low board."""
    t = Model("tv")
    t.of(WALNUT).soft_block((-0.8, 0.12, -0.2), (0.8, 0.48, 0.19), 0.008)
    t.of(WHITE)
    for x in (-0.53, 0, 0.53):
        t.soft_block((x - 0.25, 0.14, 0.19), (x + 0.25, 0.46, 0.205), 0.004)
    t.of(BLACK).legs(1.4, 0.28, 0.12, 0.05, 0.03)
    t.soft_block((-0.2, 0.48, -0.1), (0.2, 0.495, 0.08), 0.004)
    t.block((-0.03, 0.49, -0.04), (0.03, 0.6, -0.01))
    t.soft_block((-0.62, 0.56, -0.03), (0.62, 1.28, 0.01), 0.006)
    t.of(SCREEN).block((-0.605, 0.575, 0.01), (0.605, 1.265, 0.012))
    return t


def fireplace():
    f = Model("fireplace")
    f.of(STONE)
    for s in SIDES:
        f.soft_block((s * 0.55 - 0.15, 0, -0.25), (s * 0.55 + 0.15, 0.95, 0.2), 0.012)
    f.soft_block((-0.7, 0.75, -0.25), (0.7, 1.1, 0.2), 0.012)
    f.soft_block((-0.8, 1.1, -0.25), (0.8, 1.18, 0.28), 0.012)
    f.soft_block((-0.75, 0, -0.25), (0.75, 0.05, 0.45), 0.01)
    f.of(SOIL).block((-0.4, 0.05, -0.25), (0.4, 0.75, -0.2))
    f.of(BARK)
    for x0, x1, z, y in ((-0.28, 0.26, 0.02, 0.11), (-0.24, 0.28, -0.1, 0.11), (-0.2, 0.2, -0.04, 0.2)):
        f.rod((x0, y, z), (x1, y, z - 0.03), 0.05, 8)
    f.of(FIRE)
    for x, z, r, h in ((-0.1, -0.02, 0.08, 0.5), (0.06, -0.06, 0.1, 0.58), (0.17, -0.01, 0.06, 0.42)):
        f.turned(x, z, [(r * 0.5, 0.14), (r, 0.24), (r * 0.55, 0.36), (0, h)], 8)
    return f


def plant():
    p = Model("plant", "none", keeps_proportions=True).of(LEAVES)
    leaves = 22
    for i in range(leaves):
        angle = i * 2.399963  # the golden angle, as leaves grow
        rise = 1 - i / leaves
        reach, height = 0.3 - 0.16 * rise * rise, 0.42 + 0.68 * rise
        x, z = math.sin(angle), math.cos(angle)
        p.leaf((x * 0.03, 0.36, z * 0.03), (x * reach * 0.55, height * 0.93, z * reach * 0.55),
               (x * reach, height - 0.12 * (1 - rise), z * reach), 0.14)
    p.of(Surface("pot", (0.74, 0.42, 0.29), 0.85)).turned(
        0, 0, [(0.12, 0), (0.17, 0.3), (0.185, 0.3), (0.185, 0.36), (0.16, 0.36)], 20)
    p.of(SOIL).turned(0, 0, [(0.158, 0.355), (0.158, 0.362)], 20)
    return p


def lamp():
    lamp = Model("lamp", "none", keeps_proportions=True)
    lamp.of(Surface("shade", (0.98, 0.90, 0.74), 0.9, 0, 0.35)).turned(0, 0, [(0.2, 1.3), (0.14, 1.6)], 24)
    return lamp.of(DARK).turned(0, 0, [(0.15, 0), (0.15, 0.02), (0.03, 0.035), (0.012, 0.05), (0.012, 1.3)], 24)


def rug():
    r = Model("rug", "none")
    red, border = Surface("rug", (0.66, 0.33, 0.28), 1), Surface("rug border", (0.90, 0.84, 0.72), 1)
    r.of(red).block((-0.9, 0, -0.6), (0.9, 0.012, 0.6))
    r.of(border)
    for s in SIDES:
        r.block((-1, 0, 0.6 if s > 0 else -0.7), (1, 0.011, 0.7 if s > 0 else -0.6))
        r.block((0.9 if s > 0 else -1, 0, -0.6), (1 if s > 0 else -0.9, 0.011, 0.6))
    r.of(Surface("rug pattern", (0.24, 0.28, 0.38), 1)).block((-0.7, 0.012, -0.4), (0.7, 0.014, 0.4))
    return r.of(red).block((-0.55, 0.014, -0.26), (0.55, 0.016, 0.26))


MODELS = (table, round_table, coffee_table, chair, sofa, armchair, stool, bookcase, cabinet, tv, fireplace, plant, lamp,
          rug)
