"""Furniture of restaurants and bars."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
CLOTH = Surface("tablecloth", (0.93, 0.91, 0.86), 1)
CUTLERY = STEEL


def _place_setting(model, x, z, turn):
    model.at(g.turned_y(turn), g.moved(x, 0.755, z))
    model.of(PORCELAIN).turned(0, 0, [(0.06, 0), (0.11, 0.014), (0.115, 0.016), (0.085, 0.009), (0, 0.008)], 18)
    model.of(CUTLERY)
    for u in (-0.155, 0.15):
        model.block((u, 0, -0.09), (u + 0.012, 0.004, 0.1))
    model.of(GLASS).turned(0.13, -0.14, [(0.03, 0), (0.004, 0.005), (0.004, 0.07), (0.032, 0.1), (0.028, 0.16)], 10)
    model.at()


def _centre_piece(model):
    model.of(Surface("vase", (0.55, 0.66, 0.68), 0.3)).turned(0, 0, [(0.025, 0.755), (0.035, 0.79), (0.016, 0.86)], 10)
    model.of(LEAVES).rod((0, 0.85, 0), (0.01, 0.98, 0), 0.004, 5)
    model.of(Surface("flower", (0.80, 0.25, 0.28), 0.9)).ball(0.01, 0.995, 0, 0.028, 8, 5)


def dining_table():
    """Laid for two, who sit in front of it and behind it."""
    t = Model("dining_table", "none")
    t.of(CLOTH).soft_block((-0.4, 0.72, -0.4), (0.4, 0.755, 0.4), 0.012)
    t.post(0, 0, 0.5, 0.82, 0.82, 0.735, 0.8, 0.8)
    t.of(DARK).turned(0, 0, [(0.24, 0), (0.24, 0.015), (0.04, 0.05), (0.035, 0.52)], 20)
    for side, turn in ((1, 0), (-1, 180)):
        _place_setting(t, 0, side * 0.24, turn)
    _centre_piece(t)
    return t


def dining_table_four():
    """Laid for four, two in front of it and two behind it."""
    t = Model("dining_table_four", "none")
    t.of(CLOTH).soft_block((-0.7, 0.72, -0.4), (0.7, 0.755, 0.4), 0.012)
    t.post(0, 0, 0.5, 1.42, 0.82, 0.735, 1.4, 0.8)
    t.of(DARK).legs(1.2, 0.6, 0.52, 0.06, 0.05)
    for x in (-0.36, 0.36):
        for side, turn in ((1, 0), (-1, 180)):
            _place_setting(t, x, side * 0.24, turn)
    _centre_piece(t)
    return t


def round_dining_table():
    t = Model("round_dining_table", "none")
    t.of(CLOTH).turned(0, 0, [(0.6, 0.45), (0.585, 0.72), (0.575, 0.755)], 36)
    t.of(DARK).turned(0, 0, [(0.3, 0), (0.3, 0.015), (0.05, 0.05), (0.04, 0.46)], 20)
    for turn, x, z in ((0, 0, 0.4), (90, 0.4, 0), (180, 0, -0.4), (270, -0.4, 0)):
        _place_setting(t, x, z, turn)
    _centre_piece(t)
    return t


def restaurant_chair():
    c = Model("restaurant_chair")
    c.of(LEATHER).soft_block((-0.21, 0.43, -0.2), (0.21, 0.49, 0.22), 0.02)
    c.at(g.leaning(9, 0.48, -0.18)).soft_block((-0.19, 0.56, -0.2), (0.19, 0.93, -0.165), 0.016)
    c.of(WALNUT)
    for s in SIDES:
        c.block((s * 0.2 - 0.016, 0.43, -0.215), (s * 0.2 + 0.016, 0.94, -0.18))
    c.soft_block((-0.216, 0.9, -0.215), (0.216, 0.955, -0.178), 0.01)
    c.at().of(WALNUT).soft_block((-0.215, 0.39, -0.2), (0.215, 0.435, 0.215), 0.008)
    c.legs(0.38, 0.36, 0.4, 0.04, 0.028, 0.015)
    return c


def bench_seat():
    """An upholstered bench for two, its back to a wall or to another."""
    b = Model("bench_seat")
    b.of(LEATHER).soft_block((-0.6, 0.34, -0.2), (0.6, 0.47, 0.28), 0.03)
    for i in range(4):
        x = -0.6 + i * 0.3
        b.soft_block((x + 0.004, 0.47, -0.28), (x + 0.296, 1.02, -0.16), 0.035)
    b.of(WALNUT).block((-0.6, 0.06, -0.26), (0.6, 0.34, 0.24)).soft_block((-0.62, 0, -0.3), (0.62, 1.06, -0.25), 0.008)
    return b


def bar_counter():
    """Guests sit before its front."""
    b = Model("bar_counter")
    b.of(WALNUT).block((-0.5, 0.1, -0.26), (0.5, 1.06, 0.2))
    for x in (-0.25, 0.25):
        b.soft_block((x - 0.22, 0.18, 0.2), (x + 0.22, 0.98, 0.222), 0.008)
    b.of(STONE).soft_block((-0.5, 1.06, -0.32), (0.5, 1.11, 0.34), 0.008)
    b.of(DARK).block((-0.5, 0, -0.24), (0.5, 0.1, 0.16))
    b.of(BRASS).rod((-0.5, 0.2, 0.3), (0.5, 0.2, 0.3), 0.018, 8)
    for s in SIDES:
        b.rod((s * 0.4, 0.2, 0.22), (s * 0.4, 0.2, 0.3), 0.012, 6)
    return b


def bar_stool():
    s = Model("bar_stool", "none")
    s.of(LEATHER).turned(0, 0, [(0.16, 0.72), (0.185, 0.74), (0.185, 0.78), (0.15, 0.8)], 24)
    s.of(CHROME).turned(0, 0, [(0.21, 0), (0.21, 0.012), (0.04, 0.03), (0.025, 0.06), (0.025, 0.72)], 24)
    for i in range(12):
        a, b = g.turned_y(i * 30), g.turned_y((i + 1) * 30)
        s.rod(g.apply(a, (0.17, 0.28, 0)), g.apply(b, (0.17, 0.28, 0)), 0.011, 6)
    return s.rod((-0.17, 0.28, 0), (0.17, 0.28, 0), 0.009, 6)


def back_bar():
    """Shelves with bottles, for the wall behind a bar."""
    b = Model("back_bar")
    b.of(WALNUT).block((-0.5, 0, -0.2), (0.5, 0.9, 0.18)).soft_block((-0.52, 0.9, -0.2), (0.52, 0.94, 0.2), 0.006)
    for s in SIDES:
        b.soft_block((s * 0.24 - 0.225, 0.06, 0.18), (s * 0.24 + 0.225, 0.86, 0.196), 0.005)
        b.block((s * 0.48 - 0.02, 0.94, -0.2), (s * 0.48 + 0.02, 2.0, 0.05))
    b.block((-0.46, 0.94, -0.2), (0.46, 2.0, -0.18)).block((-0.52, 2.0, -0.2), (0.52, 2.06, 0.08))
    for y in (1.3, 1.65):
        b.block((-0.46, y, -0.18), (0.46, y + 0.025, 0.05))
    colors = (Surface("green bottle", (0.16, 0.34, 0.20), 0.15), Surface("brown bottle", (0.42, 0.22, 0.10), 0.15),
              Surface("clear bottle", (0.72, 0.78, 0.80), 0.15))
    for row, y in enumerate((0.94, 1.325, 1.675)):
        for i in range(7):
            tall = 0.24 + 0.02 * ((i * 5 + row * 3) % 4)
            b.of(colors[(i * 2 + row) % 3]).turned(
                -0.38 + i * 0.127, -0.06, [(0.035, y), (0.037, y + tall * 0.62), (0.014, y + tall * 0.75), (0.014, y + tall)], 8)
    return b


def wine_rack():
    w = Model("wine_rack")
    w.of(OAK)
    for s in SIDES:
        w.block((s * 0.38 - 0.02, 0, -0.16), (s * 0.38 + 0.02, 1.5, 0.14))
    for i in range(6):
        w.block((-0.36, 0.04 + i * 0.285, -0.15), (0.36, 0.06 + i * 0.285, 0.13))
    w.block((-0.36, 0, -0.16), (0.36, 1.5, -0.15))
    bottle = Surface("bottle", (0.13, 0.25, 0.16), 0.2)
    for row in range(5):
        for i in range(5):
            if (row * 3 + i) % 7 == 6:
                continue
            w.of(bottle).rod((-0.29 + i * 0.145, 0.103 + row * 0.285, -0.14), (-0.29 + i * 0.145, 0.103 + row * 0.285, 0.08), 0.041, 10)
            w.rod((-0.29 + i * 0.145, 0.103 + row * 0.285, 0.08), (-0.29 + i * 0.145, 0.103 + row * 0.285, 0.15), 0.016, 8)
    return w


def lectern():
    """For a host, or a speaker, who stands behind it."""
    m = Model("lectern")
    m.of(OAK).soft_block((-0.25, 0.04, -0.15), (0.25, 1.02, 0.15), 0.01)
    m.soft_block((-0.3, 0, -0.2), (0.3, 0.05, 0.2), 0.01)
    m.at(g.turned_x(14), g.moved(0, 1.06, 0)).soft_block((-0.3, -0.02, -0.22), (0.3, 0.02, 0.22), 0.008)
    m.of(WHITE).block((-0.14, 0.02, -0.14), (0.14, 0.026, 0.08))
    return m


def coat_rack():
    c = Model("coat_rack", "none", keeps_proportions=True)
    c.of(WALNUT).turned(0, 0, [(0.025, 0.02), (0.025, 1.7), (0.035, 1.72), (0.02, 1.76), (0, 1.77)], 12)
    for i in range(4):
        c.at(g.turned_y(90 * i))
        c.rod((0, 0.06, 0), (0.28, 0.0, 0), 0.02, 8, 0.015)
        c.rod((0, 1.5, 0), (0.13, 1.6, 0), 0.012, 6).of(BRASS).ball(0.13, 1.61, 0, 0.02, 8, 5).of(WALNUT)
    c.at().of(Surface("coat", (0.30, 0.36, 0.44), 1)).post(0.13, 0, 0.75, 0.12, 0.3, 1.58, 0.05, 0.12)
    return c


MODELS = (dining_table, dining_table_four, round_dining_table, restaurant_chair, bench_seat, bar_counter, bar_stool,
          back_bar, wine_rack, lectern, coat_rack)
