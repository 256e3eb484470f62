"""Pieces of dungeons, on a grid of one metre."""
import math

import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
SLAB = Surface("slab", (0.50, 0.48, 0.46), 0.95)
IRON = Surface("iron", (0.27, 0.27, 0.29), 0.5, 0.3)
PLANK = Surface("old planks", (0.45, 0.31, 0.20), 0.85)


def _courses(model, low, high, z0, z1, across, height=0.3, shift=0):
    """Stones in courses between two corners; `across` is how long a stone is."""
    (x0, y0), (x1, y1) = low, high
    row, y = shift, y0
    while y < y1 - 1e-9:
        top = min(y + height, y1)
        edges, x = [x0], x0 + (across / 2 if row % 2 else across)
        while x < x1 - 0.08:
            edges.append(x)
            x += across
        edges.append(x1)
        for n, (a, b) in enumerate(zip(edges, edges[1:])):
            out = 0.012 * ((n * 3 + row * 5) % 4) / 3   # stones stand out by a little
            model.soft_block((a + 0.006, y + 0.006, z0 - out + 0.012), (b - 0.006, top - 0.006, z1 + out - 0.012), 0.018)
        row, y = row + 1, top
    model.of(MORTAR).block((x0 + 0.01, y0, z0 + 0.02), (x1 - 0.01, y1 - 0.01, z1 - 0.02)).of(STONE)


def dungeon_wall():
    """Fills a square of the grid."""
    m = Model("dungeon_wall", "none").of(STONE)
    _courses(m, (-0.5, 0), (0.5, 1.5), -0.5, 0.5, 0.5)
    return m


def dungeon_floor():
    m = Model("dungeon_floor", "none").of(SLAB)
    for x0, z0, x1, z1 in ((-0.5, -0.5, 0, 0.1), (0, -0.5, 0.5, -0.1), (0, -0.1, 0.5, 0.5), (-0.5, 0.1, 0, 0.5)):
        m.soft_block((x0 + 0.008, 0, z0 + 0.008), (x1 - 0.008, 0.05, z1 - 0.008), 0.01)
    return m.of(MORTAR).block((-0.5, 0, -0.5), (0.5, 0.038, 0.5))


def _gateway(model):
    """A stone arch of one metre around a way 0.7 m wide."""
    model.of(STONE)
    for s in SIDES:
        x0, x1 = sorted((s * 0.5, s * 0.36))
        for i in range(4):
            model.soft_block((x0 + 0.004, i * 0.27 + 0.005, -0.2), (x1 - 0.004, (i + 1) * 0.27 - 0.005, 0.2), 0.015)
    inner, outer, n = 0.36, 0.5, 9
    for i in range(n):
        a, b = math.pi * i / n + 0.02, math.pi * (i + 1) / n - 0.02
        outline = [(r * math.cos(t), 1.08 + r * math.sin(t) * 0.8) for r, t in ((inner, a), (outer, a), (outer, b), (inner, b))]
        model.extruded(outline, -0.2, 0.2)
    angles = [math.pi * i / 12 for i in range(13)]
    arcs = [[(r * math.cos(t), 1.08 + r * math.sin(t) * 0.8) for t in angles] for r in (inner + 0.01, outer - 0.01)]
    model.of(MORTAR).extruded(arcs[1] + arcs[0][::-1], -0.185, 0.185)
    for s in SIDES:
        x0, x1 = sorted((s * 0.49, s * 0.37))
        model.block((x0, 0, -0.185), (x1, 1.08, 0.185))
    # What fills the corners above, so that a wall can end at a straight edge.
    rim = [(0.5 * math.cos(t), 1.08 + 0.5 * math.sin(t) * 0.8) for t in angles]
    model.of(STONE).extruded(rim + [(-0.5, 1.5), (0.5, 1.5)], -0.18, 0.18)


def _arched(half, foot, top):
    return [(-half, foot), (half, foot)] + [(half * math.cos(math.pi * i / 10), top + half * 0.8 * math.sin(math.pi * i / 10)) for i in range(11)]


def dungeon_door():
    """Of planks, in a stone arch; a program's colour paints the planks, as of a lock that a key of this colour opens."""
    m = Model("dungeon_door", role="opening").of(PLANK).extruded(_arched(0.36, 0, 1.08), -0.05, 0.05)
    for x in (-0.18, 0, 0.18):
        for s in SIDES:
            m.of(SOIL).block((x - 0.006, 0.02, s * 0.0525 - 0.0025), (x + 0.006, 1.28, s * 0.0525 + 0.0025))
    m.of(IRON)
    for y in (0.25, 0.95):
        for s in SIDES:
            m.soft_block((-0.34, y, s * 0.058 - 0.012), (0.28, y + 0.08, s * 0.058 + 0.012), 0.006)
    for s in SIDES:
        m.at(g.turned_x(90 * s), g.moved(0.24, 0.66, s * 0.05)).turned(0, 0, [(0.06, 0), (0.055, 0.02)], 12)
        m.of(BLACK).turned(0, 0, [(0.018, 0.02), (0.018, 0.022)], 8).of(IRON)
    m.at()
    _gateway(m)
    return m


def portcullis():
    m = Model("portcullis", role="opening").of(IRON)
    for i in range(5):
        x = -0.28 + i * 0.14
        m.rod((x, 0.06, 0), (x, 1.3 - abs(x) * 0.5, 0), 0.022, 8).turned(x, 0, [(0, 0), (0.028, 0.07)], 8)
    for i in range(4):
        m.rod((-0.35, 0.24 + i * 0.27, 0), (0.35, 0.24 + i * 0.27, 0), 0.018, 8)
    _gateway(m)
    return m


def dungeon_arch():
    """A way without a door."""
    m = Model("dungeon_arch", role="opening")
    _gateway(m)
    return m


def key():
    """Large enough to be seen, standing on a stone."""
    m = Model("key", keeps_proportions=True).of(GOLD)
    for i in range(12):
        a, b = (2 * math.pi * k / 12 for k in (i, i + 1))
        m.rod((0.12 * math.cos(a), 0.72 + 0.12 * math.sin(a), 0), (0.12 * math.cos(b), 0.72 + 0.12 * math.sin(b), 0), 0.03, 8)
    m.rod((0, 0.6, 0), (0, 0.16, 0), 0.03, 10)
    m.soft_block((0.02, 0.18, -0.02), (0.14, 0.24, 0.02), 0.006).soft_block((0.02, 0.29, -0.02), (0.12, 0.34, 0.02), 0.006)
    return m.of(STONE).turned(0, 0, [(0.2, 0), (0.2, 0.06), (0.14, 0.08), (0.12, 0.16)], 16)


def chest():
    m = Model("chest").of(PLANK)
    m.soft_block((-0.4, 0, -0.26), (0.4, 0.34, 0.26), 0.012)
    lid = [(-0.26, 0.345), (0.26, 0.345)] + [(0.26 * math.cos(math.pi * i / 8), 0.36 + 0.17 * math.sin(math.pi * i / 8)) for i in range(9)]
    m.at(g.turned_y(-90)).extruded(lid, -0.4, 0.4)
    m.of(BRASS)
    band = [(x * 1.04, y + (0.012 if y > 0.35 else 0)) for x, y in lid]
    for x in (-0.32, 0.32):
        m.at(g.turned_y(-90), g.moved(x, 0, 0)).extruded(band, -0.035, 0.035)
        m.at().block((x - 0.035, 0, 0.26), (x + 0.035, 0.34, 0.272)).block((x - 0.035, 0, -0.272), (x + 0.035, 0.34, -0.26))
    m.soft_block((-0.07, 0.24, 0.26), (0.07, 0.42, 0.29), 0.01)
    return m.of(BLACK).block((-0.012, 0.28, 0.29), (0.012, 0.33, 0.293))


def open_chest():
    m = Model("open_chest").of(PLANK)
    m.soft_block((-0.4, 0, -0.26), (0.4, 0.3, 0.26), 0.012)
    for s in SIDES:
        m.block((s * 0.385 - 0.015, 0.3, -0.26), (s * 0.385 + 0.015, 0.34, 0.26)).block((-0.37, 0.3, s * 0.245 - 0.015), (0.37, 0.34, s * 0.245 + 0.015))
    lid = [(-0.26, 0), (0.26, 0)] + [(0.26 * math.cos(math.pi * i / 8), 0.015 + 0.17 * math.sin(math.pi * i / 8)) for i in range(9)]
    m.at(g.turned_y(-90), g.moved(0, 0, 0.26), g.turned_x(-100), g.moved(0, 0.35, -0.26)).extruded(lid, -0.4, 0.4)
    m.at().of(BRASS).soft_block((-0.07, 0.2, 0.26), (0.07, 0.33, 0.29), 0.01)
    m.of(GOLD)
    for i in range(16):
        a, r = i * 2.4, 0.05 + 0.013 * i
        m.turned(r * math.cos(a) * 1.4, r * math.sin(a) * 0.8, [(0.045, 0.3), (0.045, 0.335 + 0.02 * (i % 4))], 8)
    return m


def dungeon_stairs():
    """Up to the next level, from its front to its back."""
    m = Model("dungeon_stairs").of(SLAB)
    for i in range(5):
        z = 0.5 - i * 0.2
        m.soft_block((-0.4, 0, z - 0.2), (0.4, (i + 1) * 0.2, z), 0.014)
    m.of(STONE)
    for s in SIDES:
        x0, x1 = sorted((s * 0.5, s * 0.39))
        for i in range(3):
            m.soft_block((x0, 0, 0.5 - (i + 1) / 3), (x1, 0.45 + i * 0.35, 0.5 - i / 3 - 0.006), 0.018)
    return m


def torch():
    """To be placed at a height of 0.8 m, its back to a wall."""
    m = Model("torch").of(IRON).soft_block((-0.04, 0.02, -0.1), (0.04, 0.22, -0.08), 0.008)
    m.rod((0, 0.1, -0.08), (0, 0.12, 0.0), 0.015, 8).turned(0, 0.02, [(0.035, 0.14), (0.05, 0.22), (0.05, 0.24)], 12)
    m.of(PLANK).rod((0, 0.0, 0.0), (0, 0.24, 0.02), 0.025, 8)
    return m.of(FIRE).turned(0, 0.02, [(0.03, 0.24), (0.055, 0.3), (0.035, 0.38), (0, 0.5)], 10)


def brazier():
    m = Model("brazier", "none", keeps_proportions=True).of(IRON)
    m.turned(0, 0, [(0.1, 0.5), (0.25, 0.6), (0.28, 0.72), (0.25, 0.72), (0.2, 0.66)], 18)
    for i in range(3):
        m.at(g.turned_y(i * 120)).rod((0, 0.52, 0.1), (0, 0, 0.24), 0.022, 8)
    m.at().of(BARK)
    for i in range(3):
        m.at(g.turned_y(i * 60)).rod((-0.18, 0.7, 0), (0.18, 0.74, 0), 0.035, 6)
    return m.at().of(FIRE).turned(0, 0, [(0.1, 0.7), (0.16, 0.82), (0.09, 1.0), (0, 1.2)], 12)


def barrel():
    m = Model("barrel", "none", keeps_proportions=True).of(PLANK)
    m.turned(0, 0, [(0.25, 0), (0.3, 0.2), (0.31, 0.38), (0.3, 0.56), (0.25, 0.76), (0.225, 0.76), (0.225, 0.73)], 18)
    m.of(IRON)
    for y, r in ((0.08, 0.276), (0.24, 0.311), (0.48, 0.311), (0.64, 0.283)):
        m.turned(0, 0, [(r, y), (r + 0.004, y + 0.025), (r, y + 0.05)], 18)
    return m


def crate():
    m = Model("crate", "none").of(PINE)
    m.block((-0.28, 0.01, -0.28), (0.28, 0.59, 0.28))
    m.of(OAK)
    for s in SIDES:
        for t in SIDES:
            m.soft_block((s * 0.265 - 0.035, 0, t * 0.265 - 0.035), (s * 0.265 + 0.035, 0.6, t * 0.265 + 0.035), 0.006)
            for y in (0.035, 0.565):
                m.block((-0.23, y - 0.035, t * 0.28 - 0.02), (0.23, y + 0.035, t * 0.28 + 0.02))
                m.block((s * 0.28 - 0.02, y - 0.035, -0.23), (s * 0.28 + 0.02, y + 0.035, 0.23))
    for s in SIDES:
        m.at(g.turned_z(45), g.moved(0, 0.3, s * 0.285)).block((-0.33, -0.03, -0.012), (0.33, 0.03, 0.012))
    return m.at()


def treasure():
    m = Model("treasure", "none", keeps_proportions=True).of(GOLD)
    m.turned(0, 0, [(0.42, 0), (0.4, 0.04), (0.2, 0.17), (0, 0.2)], 14)
    for i in range(26):
        a, r = i * 2.4, 0.42 * (i / 26) ** 0.5
        y = 0.2 - 0.45 * r + 0.01 * (i % 3)
        m.at(g.turned_z(20 * (i % 3 - 1)), g.moved(r * math.cos(a), max(y, 0.01), r * math.sin(a))).turned(0, 0, [(0.05, 0), (0.05, 0.016)], 8)
    m.at().of(Surface("ruby", (0.75, 0.10, 0.18), 0.15)).turned(0.12, 0.12, [(0, 0.14), (0.05, 0.19), (0.03, 0.22)], 6)
    return m.of(Surface("emerald", (0.10, 0.58, 0.32), 0.15)).turned(-0.14, 0.05, [(0, 0.13), (0.045, 0.18), (0.028, 0.205)], 6)


def skeleton():
    """What is left of an earlier guest, lying on the floor."""
    m = Model("skeleton").of(Surface("bone", (0.90, 0.87, 0.76), 0.9))
    m.ball(0, 0.09, -0.36, 0.09, 12, 8).soft_block((-0.05, 0.02, -0.32), (0.05, 0.08, -0.27), 0.015)
    m.rod((0, 0.04, -0.28), (0, 0.04, 0.1), 0.02, 6)
    for i in range(4):
        for s in SIDES:
            z = -0.22 + i * 0.07
            m.rod((0, 0.06, z), (s * 0.12, 0.05, z + 0.02), 0.012, 6)
    for s in SIDES:
        m.rod((s * 0.02, 0.03, 0.1), (s * 0.1, 0.03, 0.3), 0.018, 6).rod((s * 0.1, 0.03, 0.3), (s * 0.07, 0.03, 0.5), 0.015, 6)
        m.rod((s * 0.12, 0.03, -0.22), (s * 0.26, 0.03, -0.06), 0.014, 6).rod((s * 0.26, 0.03, -0.06), (s * 0.24, 0.03, 0.12), 0.012, 6)
    m.of(BLACK)
    for s in SIDES:
        m.ball(s * 0.034, 0.13, -0.3, 0.022, 6, 4)
    return m


MODELS = (dungeon_wall, dungeon_floor, dungeon_door, portcullis, dungeon_arch, key, chest, open_chest, dungeon_stairs,
          torch, brazier, barrel, crate, treasure, skeleton)
