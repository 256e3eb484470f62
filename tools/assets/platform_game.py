"""Tiles of platform games, seen from their front; a tile is one metre wide, high and deep."""
import math

import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
EARTH = Surface("earth", (0.60, 0.42, 0.27), 1)
PEBBLE = Surface("pebble", (0.72, 0.55, 0.38), 1)
TURF = Surface("turf", (0.42, 0.70, 0.28), 0.9)
CLAY = Surface("clay brick", (0.76, 0.43, 0.28), 0.85)
JOINT = Surface("joint", (0.45, 0.27, 0.18), 1)
PIPE = Surface("pipe", (0.25, 0.62, 0.30), 0.35)
CREAM = Surface("cream", (0.96, 0.94, 0.86), 0.8)
RED = Surface("red cloth", (0.82, 0.22, 0.20), 0.8)


def _pebbles(model, places):
    model.of(PEBBLE)
    for x, y, w in places:
        model.soft_block((x - w, y - 0.06, 0.49), (x + w, y + 0.06, 0.512), 0.01)


def ground_tile():
    """Earth with turf on it."""
    m = Model("ground_tile").of(TURF).soft_block((-0.5, 0.8, -0.5), (0.5, 1, 0.5), 0.01)
    teeth = [(-0.5 + i * 0.125, 0.8 - (0.1 if i % 2 else 0.02)) for i in range(9)]
    m.extruded(teeth + [(0.5, 0.85), (-0.5, 0.85)], 0.49, 0.515)
    m.of(EARTH).block((-0.5, 0, -0.5), (0.5, 0.8, 0.5))
    _pebbles(m, ((-0.25, 0.5, 0.1), (0.22, 0.3, 0.14), (-0.1, 0.16, 0.08)))
    return m


def earth_tile():
    """What lies below the ground."""
    m = Model("earth_tile").of(EARTH).block((-0.5, 0, -0.5), (0.5, 1, 0.5))
    _pebbles(m, ((-0.22, 0.72, 0.12), (0.25, 0.55, 0.1), (-0.12, 0.3, 0.1), (0.2, 0.16, 0.14)))
    return m


def gap_tile():
    """A pit with a glowing floor, in place of the ground."""
    m = Model("gap_tile").of(Surface("lava", (0.95, 0.42, 0.12), 0.6, 0, 0.7)).block((-0.5, 0.06, -0.5), (0.5, 0.3, 0.5))
    for x, z, r in ((-0.2, 0.1, 0.12), (0.22, -0.15, 0.09), (0.05, 0.3, 0.07)):
        m.turned(x, z, [(r, 0.3), (r * 0.7, 0.32), (0, 0.34)], 10)
    return m.of(JOINT).block((-0.5, 0, -0.5), (0.5, 0.06, 0.5))


def brick_tile():
    """Of bricks."""
    m = Model("brick_tile").of(CLAY)
    for row in range(4):
        y0, shift = row * 0.25, 0.125 if row % 2 else 0
        edges = [-0.5] + [x for x in (-0.25 + shift, 0.0 + shift, 0.25 + shift) if x < 0.5] + [0.5]
        if shift:
            edges.insert(1, -0.375 + 0.25 - 0.25 + 0.0)
        for a, b in zip(edges, edges[1:]):
            m.soft_block((a + 0.012, y0 + 0.012, -0.5), (b - 0.012, y0 + 0.238, 0.5), 0.015)
    return m.of(JOINT).block((-0.492, 0.008, -0.485), (0.492, 0.992, 0.485))


def bonus_tile():
    m = Model("bonus_tile").of(Surface("bonus", (0.97, 0.74, 0.22), 0.4, 0.1)).soft_block((-0.5, 0, -0.5), (0.5, 1, 0.5), 0.05)
    m.of(JOINT)
    for x in (-0.38, 0.38):
        for y in (0.12, 0.88):
            m.at(g.turned_x(90), g.moved(x, y, 0.5)).turned(0, 0, [(0.035, 0), (0.03, 0.02)], 8)
    m.at().of(CREAM)  # a question mark of bars
    for low, high in (((-0.18, 0.7), (0.18, 0.8)), ((0.08, 0.5), (0.18, 0.7)), ((-0.18, 0.6), (-0.08, 0.7)),
                      ((-0.05, 0.42), (0.18, 0.52)), ((-0.05, 0.34), (0.05, 0.42)), ((-0.05, 0.18), (0.05, 0.28))):
        m.block((low[0], low[1], 0.5), (high[0], high[1], 0.525))
    return m


def stone_tile():
    m = Model("stone_tile").of(STONE).soft_block((-0.5, 0, -0.5), (0.5, 1, 0.5), 0.06)
    return m.soft_block((-0.3, 0.2, 0.35), (0.3, 0.8, 0.53), 0.06)


def _pipe(name, height):
    m = Model(name, "none").of(PIPE).turned(0, 0, [(0.82, 0), (0.82, height - 0.5)], 28)
    rings = [(0.82, height - 0.5), (0.98, height - 0.5), (1.0, height - 0.47), (1.0, height - 0.03), (0.98, height), (0.8, height), (0.8, height - 0.15)]
    m.turned(0, 0, rings, 28)
    return m.of(Surface("inside", (0.05, 0.14, 0.07), 1)).turned(0, 0, [(0.79, height - 0.15), (0.79, height - 0.14)], 28)


def pipe():
    return _pipe("pipe", 2)


def tall_pipe():
    return _pipe("tall_pipe", 3)


def floating_platform():
    """Three tiles long."""
    m = Model("floating_platform").of(TURF).soft_block((-1.5, 0.38, -0.5), (1.5, 0.5, 0.5), 0.03)
    m.of(EARTH)
    outline = [(-1.45, 0.38), (-1.3, 0.2), (-0.8, 0.12), (-0.3, 0.0), (0.35, 0.03), (0.9, 0.14), (1.3, 0.2), (1.45, 0.38)]
    return m.extruded(outline, -0.46, 0.46)


def plank_bridge():
    """Of planks, one tile long."""
    m = Model("plank_bridge").of(OAK)
    for i in range(4):
        x = -0.375 + i * 0.25
        m.soft_block((x - 0.11, 0, -0.48), (x + 0.11, 0.09, 0.48), 0.012)
    m.of(WALNUT)
    for s in SIDES:
        m.rod((-0.5, 0.5, s * 0.46), (0.5, 0.5, s * 0.46), 0.025, 8).rod((0, 0, s * 0.46), (0, 0.55, s * 0.46), 0.035, 8)
    return m


def cloud():
    m = Model("cloud", "none", keeps_proportions=True).of(Surface("cloud", (0.97, 0.98, 1.0), 1, 0, 0.15))
    for x, y, z, r in ((0, 0.5, 0, 0.5), (-0.62, 0.4, 0.05, 0.36), (0.62, 0.42, 0.02, 0.4), (-1.05, 0.3, 0, 0.22), (1.1, 0.32, 0, 0.22), (0.15, 0.4, 0.25, 0.36)):
        m.ball(x, y * 0.9, z, r, 14, 8)
    return m


def goal_flag():
    """The end of a level: a pole with a flag."""
    m = Model("goal_flag").of(RED).extruded([(0.03, 2.95), (0.03, 2.25), (1.0, 2.6)], -0.015, 0.015)
    m.of(STEEL).turned(0, 0, [(0.04, 0.3), (0.035, 3.05)], 12)
    return m.of(GOLD).ball(0, 3.12, 0, 0.1, 14, 8).of(STONE).soft_block((-0.3, 0, -0.3), (0.3, 0.3, 0.3), 0.04)


def hero():
    """1.6 tiles tall, for scale; looks to the front."""
    m = Model("hero", keeps_proportions=True)
    jacket, trousers = Surface("jacket", (0.16, 0.47, 0.52), 0.8), Surface("trousers", (0.36, 0.29, 0.24), 0.9)
    m.of(jacket).turned(0, 0, [(0.25, 0.5), (0.27, 0.75), (0.23, 0.98), (0.12, 1.06)], 16)
    for s in SIDES:
        m.of(jacket).rod((s * 0.2, 0.97, 0), (s * 0.38, 0.66, 0.08), 0.08, 10)
        m.of(SKIN).ball(s * 0.4, 0.62, 0.1, 0.08, 10, 6)
        m.of(trousers).rod((s * 0.12, 0.56, 0), (s * 0.14, 0.14, 0), 0.115, 10)
        m.of(BARK).soft_block((s * 0.15 - 0.1, 0, -0.13), (s * 0.15 + 0.1, 0.16, 0.22), 0.04)
    m.of(trousers).turned(0, 0, [(0.2, 0.42), (0.25, 0.52)], 16)
    m.of(BRASS).soft_block((-0.05, 0.5, 0.22), (0.05, 0.58, 0.27), 0.01)
    m.of(Surface("scarf", (0.95, 0.55, 0.18), 0.9)).turned(0, 0, [(0.17, 0.98), (0.2, 1.03), (0.16, 1.09)], 16)
    m.soft_block((0.06, 0.72, -0.29), (0.2, 1.05, -0.22), 0.02)
    m.of(Surface("rucksack", (0.62, 0.42, 0.24), 0.9)).soft_block((-0.2, 0.6, -0.4), (0.2, 0.98, -0.2), 0.05)
    m.of(SKIN).ball(0, 1.28, 0, 0.24, 16, 10).ball(0, 1.25, 0.245, 0.035, 8, 5)
    m.of(BLACK)
    for s in SIDES:
        m.ball(s * 0.09, 1.31, 0.215, 0.034, 8, 5)
    m.soft_block((-0.06, 1.16, 0.185), (0.06, 1.175, 0.222), 0.005)
    m.of(Surface("hair", (0.42, 0.25, 0.14), 0.9)).ball(0, 1.345, -0.035, 0.25, 14, 8)
    for x, y, z in ((-0.12, 1.5, 0.12), (0.02, 1.53, 0.12), (0.14, 1.49, 0.1)):
        m.ball(x, y, z, 0.09, 8, 5)
    return m


def coin():
    m = Model("coin").of(GOLD).at(g.turned_x(90), g.moved(0, 0.35, 0))
    m.turned(0, 0, [(0.3, -0.05), (0.33, -0.03), (0.33, 0.03), (0.3, 0.05)], 24)
    return m.at().block((-0.06, 0.17, -0.065), (0.06, 0.53, 0.065))


def spikes():
    m = Model("spikes", "none").of(STEEL)
    for i in range(3):
        for k in range(3):
            m.turned(-0.33 + i * 0.33, -0.33 + k * 0.33, [(0.15, 0.1), (0, 0.7)], 8)
    return m.of(DARK).soft_block((-0.5, 0, -0.5), (0.5, 0.1, 0.5), 0.02)


def ladder():
    m = Model("ladder").of(OAK)
    for s in SIDES:
        m.soft_block((s * 0.3 - 0.04, 0, -0.04), (s * 0.3 + 0.04, 1, 0.04), 0.01)
    for i in range(4):
        m.rod((-0.3, 0.125 + i * 0.25, 0), (0.3, 0.125 + i * 0.25, 0), 0.03, 8)
    return m


def creature():
    """Walks about and does harm."""
    m = Model("creature", keeps_proportions=True).of(Surface("creature", (0.58, 0.33, 0.50), 0.8))
    m.turned(0, 0, [(0.28, 0.16), (0.42, 0.3), (0.4, 0.55), (0.25, 0.75), (0, 0.82)], 18)
    for s in SIDES:
        m.of(WHITE).ball(s * 0.14, 0.52, 0.33, 0.1, 10, 6)
        m.of(BLACK).ball(s * 0.13, 0.52, 0.415, 0.04, 8, 5)
        m.of(BARK).soft_block((s * 0.2 - 0.14, 0, -0.15), (s * 0.2 + 0.14, 0.17, 0.25), 0.05)
    return m.of(WHITE).post(-0.08, 0.37, 0.28, 0.01, 0.02, 0.36, 0.07, 0.04).post(0.08, 0.37, 0.28, 0.01, 0.02, 0.36, 0.07, 0.04)


def hill():
    """Stands behind a level."""
    m = Model("hill", keeps_proportions=True).of(Surface("far turf", (0.50, 0.72, 0.45), 1))
    outline = [(-2.0, 0)] + [(2.0, 0)] + [(2 * math.cos(a * math.pi / 12), 1.6 * math.sin(a * math.pi / 12) ** 1.3) for a in range(1, 12)]
    return m.extruded(outline, -0.25, 0.25)


def bush():
    m = Model("bush", "none", keeps_proportions=True).of(LEAVES)
    for x, y, z, r in ((0, 0.3, 0, 0.36), (-0.38, 0.22, 0.04, 0.27), (0.38, 0.22, 0.03, 0.28), (0.1, 0.25, 0.2, 0.26)):
        m.ball(x, y, z, r, 12, 7)
    return m


MODELS = (ground_tile, earth_tile, gap_tile, brick_tile, bonus_tile, stone_tile, pipe, tall_pipe, floating_platform,
          plank_bridge, cloud, goal_flag, hero, coin, spikes, ladder, creature, hill, bush)
