"""A kitchen of units 60 cm wide and deep."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
FRONT = Surface("kitchen front", (0.90, 0.91, 0.89), 0.4)
WORKTOP = Surface("worktop", (0.38, 0.36, 0.35), 0.35)


def _unit(model, width=0.6, doors=1, drawer=True, top=0.86):
    """A floor unit without its worktop, its primary surface the fronts."""
    half = width / 2
    model.of(FRONT).block((-half, 0.1, -0.3), (half, top, 0.27))
    each = width / doors
    for i in range(doors):
        x0, x1 = -half + i * each + 0.004, -half + (i + 1) * each - 0.004
        edge = 0.68 if drawer else 0.855
        model.of(FRONT).soft_block((x0, 0.105, 0.27), (x1, edge, 0.29), 0.004)
        if drawer:
            model.soft_block((x0, 0.69, 0.27), (x1, 0.855, 0.29), 0.004)
            model.of(STEEL).block(((x0 + x1) / 2 - 0.08, 0.77, 0.305), ((x0 + x1) / 2 + 0.08, 0.782, 0.317))
            for s in SIDES:
                model.block(((x0 + x1) / 2 + s * 0.07 - 0.005, 0.77, 0.29), ((x0 + x1) / 2 + s * 0.07 + 0.005, 0.782, 0.305))
        model.of(STEEL).block((x1 - 0.05, edge - 0.2, 0.305), (x1 - 0.038, edge - 0.04, 0.317))
        for y in (edge - 0.19, edge - 0.06):
            model.block((x1 - 0.05, y, 0.29), (x1 - 0.038, y + 0.01, 0.305))
    model.of(DARK).block((-half, 0, -0.3), (half, 0.1, 0.22))


def counter():
    c = Model("counter")
    _unit(c)
    c.of(WORKTOP).soft_block((-0.3, 0.86, -0.3), (0.3, 0.9, 0.31), 0.005)
    return c


def corner_counter():
    """Two fronts, towards its front and its right."""
    c = Model("corner_counter")
    c.of(FRONT).block((-0.45, 0.1, -0.45), (0.45, 0.86, 0.12))
    c.block((-0.45, 0.1, 0.12), (0.12, 0.86, 0.45))
    c.of(WORKTOP).soft_block((-0.45, 0.86, -0.45), (0.45, 0.9, 0.16), 0.005)
    c.soft_block((-0.45, 0.86, 0.14), (0.16, 0.9, 0.45), 0.005)
    c.of(FRONT).soft_block((0.165, 0.11, 0.12), (0.446, 0.85, 0.14), 0.004)
    c.soft_block((0.12, 0.11, 0.165), (0.14, 0.85, 0.446), 0.004)
    c.of(DARK).block((-0.45, 0, -0.45), (0.45, 0.1, 0.07)).block((-0.45, 0, 0.07), (0.07, 0.1, 0.45))
    return c


def sink():
    s = Model("sink")
    _unit(s, 0.8, 2, drawer=False, top=0.715)
    s.of(FRONT).block((-0.4, 0.715, 0.25), (0.4, 0.86, 0.27))
    for sign in SIDES:
        s.block((sign * 0.39 - 0.01, 0.715, -0.3), (sign * 0.39 + 0.01, 0.86, 0.25))
    s.of(WORKTOP)
    for low, high in (((-0.4, -0.3), (0.4, -0.19)), ((-0.4, 0.17), (0.4, 0.31)), ((-0.4, -0.19), (-0.29, 0.17)),
                      ((0.29, -0.19), (0.4, 0.17))):
        s.block((low[0], 0.86, low[1]), (high[0], 0.9, high[1]))
    s.of(STEEL).block((-0.29, 0.72, -0.19), (0.29, 0.735, 0.17))
    for sign in SIDES:
        x = sign * 0.285
        s.block((x - 0.012, 0.72, -0.19), (x + 0.012, 0.905, 0.17))
        z = -0.19 if sign < 0 else 0.158
        s.block((-0.29, 0.72, z), (0.29, 0.905, z + 0.012))
    s.of(DARK).turned(0, 0, [(0.035, 0.735), (0.035, 0.738)], 16)
    s.of(CHROME).turned(0, -0.24, [(0.028, 0.9), (0.028, 0.93), (0.014, 0.94), (0.014, 1.15)], 12)
    s.rod((0, 1.14, -0.24), (0, 1.2, -0.2), 0.014, 10).rod((0, 1.2, -0.2), (0, 1.2, -0.1), 0.014, 10)
    s.rod((0, 1.2, -0.1), (0, 1.12, -0.06), 0.014, 10).rod((0.02, 0.96, -0.24), (0.1, 0.99, -0.24), 0.008, 8)
    return s


def stove():
    s = Model("stove")
    s.of(Surface("enamel", (0.93, 0.93, 0.92), 0.25)).block((-0.3, 0.06, -0.3), (0.3, 0.88, 0.27))
    s.soft_block((-0.297, 0.74, 0.27), (0.297, 0.875, 0.3), 0.006)
    s.soft_block((-0.297, 0.07, 0.27), (0.297, 0.2, 0.295), 0.006)
    s.of(BLACK).soft_block((-0.3, 0.88, -0.3), (0.3, 0.9, 0.3), 0.006)
    s.soft_block((-0.297, 0.21, 0.27), (0.297, 0.73, 0.295), 0.006)
    s.block((-0.28, 0, -0.28), (0.28, 0.06, 0.24))
    s.of(SCREEN).block((-0.2, 0.3, 0.295), (0.2, 0.58, 0.298))
    s.of(STEEL)
    s.rod((-0.24, 0.67, 0.325), (0.24, 0.67, 0.325), 0.011, 10)
    for sign in SIDES:
        s.rod((sign * 0.22, 0.67, 0.29), (sign * 0.22, 0.67, 0.325), 0.008, 8)
    plate = Surface("hot plate", (0.30, 0.29, 0.29), 0.5)
    for x, z, r in ((-0.14, -0.13, 0.1), (0.14, -0.13, 0.075), (-0.14, 0.14, 0.075), (0.14, 0.14, 0.1)):
        s.of(plate).turned(x, z, [(r, 0.9), (r, 0.908), (r - 0.012, 0.912)], 20)
    for i in range(5):
        s.of(STEEL).at(g.turned_x(90), g.moved(-0.2 + 0.1 * i, 0.808, 0.3)).turned(0, 0, [(0.022, 0), (0.017, 0.03)], 12)
    return s


def fridge():
    f = Model("fridge")
    f.of(Surface("fridge", (0.87, 0.88, 0.89), 0.3, 0.1)).soft_block((-0.3, 0.04, -0.32), (0.3, 1.85, 0.26), 0.01)
    f.soft_block((-0.298, 0.05, 0.268), (0.298, 0.68, 0.32), 0.012)
    f.soft_block((-0.298, 0.69, 0.268), (0.298, 1.848, 0.32), 0.012)
    f.of(DARK).block((-0.29, 0.045, 0.255), (0.29, 1.84, 0.27)).block((-0.28, 0, -0.3), (0.28, 0.045, 0.24))
    f.of(STEEL)
    for y0, y1 in ((0.42, 0.64), (0.76, 1.3)):
        f.rod((0.25, y0, 0.355), (0.25, y1, 0.355), 0.011, 8)
        for y in (y0 + 0.02, y1 - 0.02):
            f.rod((0.25, y, 0.315), (0.25, y, 0.355), 0.008, 6)
    return f


def cupboard():
    """A tall cupboard for provisions."""
    c = Model("cupboard")
    c.of(FRONT).block((-0.3, 0.1, -0.3), (0.3, 2.1, 0.27))
    for y0, y1 in ((0.105, 0.98), (0.99, 2.095)):
        c.of(FRONT).soft_block((-0.296, y0, 0.27), (0.296, y1, 0.29), 0.004)
    c.of(STEEL)
    for y in (0.72, 1.03):
        c.block((0.24, y, 0.305), (0.252, y + 0.2, 0.317))
        for k in (0.01, 0.18):
            c.block((0.24, y + k, 0.29), (0.252, y + k + 0.01, 0.305))
    c.of(DARK).block((-0.3, 0, -0.3), (0.3, 0.1, 0.22))
    return c


def wall_cupboard():
    """To be placed at a height of 1.4 m, its back to a wall."""
    c = Model("wall_cupboard")
    c.of(FRONT).block((-0.3, 0, -0.175), (0.3, 0.7, 0.155))
    for s in SIDES:
        c.soft_block((s * 0.15 - 0.146, 0.004, 0.155), (s * 0.15 + 0.146, 0.696, 0.175), 0.004)
    c.of(STEEL)
    for s in SIDES:
        c.block((s * 0.03 - 0.006, 0.04, 0.185), (s * 0.03 + 0.006, 0.18, 0.197))
        for y in (0.05, 0.16):
            c.block((s * 0.03 - 0.006, y, 0.175), (s * 0.03 + 0.006, y + 0.01, 0.185))
    return c


def hood():
    """To be placed above a stove, at a height of 1.6 m."""
    h = Model("hood").of(STEEL)
    h.post(0, 0, 0.06, 0.6, 0.5, 0.28, 0.24, 0.22, 0, -0.14)
    h.block((-0.3, 0, -0.25), (0.3, 0.06, 0.25)).block((-0.11, 0.28, -0.25), (0.11, 0.8, -0.04))
    return h.of(BLACK).block((-0.08, 0.02, 0.25), (0.08, 0.04, 0.254))


def dishwasher():
    d = Model("dishwasher")
    d.of(Surface("enamel", (0.93, 0.93, 0.92), 0.25)).block((-0.3, 0.08, -0.3), (0.3, 0.86, 0.27))
    d.soft_block((-0.297, 0.1, 0.27), (0.297, 0.74, 0.3), 0.008)
    d.of(BLACK).soft_block((-0.297, 0.745, 0.27), (0.297, 0.857, 0.3), 0.006).block((-0.28, 0, -0.28), (0.28, 0.08, 0.22))
    d.of(STEEL).rod((-0.22, 0.68, 0.33), (0.22, 0.68, 0.33), 0.011, 8)
    for s in SIDES:
        d.rod((s * 0.2, 0.68, 0.295), (s * 0.2, 0.68, 0.33), 0.008, 6)
    d.of(WORKTOP).soft_block((-0.3, 0.86, -0.3), (0.3, 0.9, 0.31), 0.005)
    return d


def kitchen_island():
    k = Model("kitchen_island")
    k.of(FRONT).block((-0.8, 0.1, -0.4), (0.8, 0.86, 0.32))
    for i in range(3):
        x = -0.533 + i * 0.533
        for y0, y1 in ((0.11, 0.48), (0.49, 0.85)):
            k.of(FRONT).soft_block((x - 0.262, y0, 0.32), (x + 0.262, y1, 0.34), 0.004)
            k.of(STEEL).block((x - 0.1, y1 - 0.06, 0.34), (x + 0.1, y1 - 0.048, 0.362))
    k.of(OAK).soft_block((-0.85, 0.86, -0.45), (0.85, 0.91, 0.4), 0.008)
    k.of(DARK).block((-0.76, 0, -0.36), (0.76, 0.1, 0.28))
    k.of(PORCELAIN).turned(0.4, 0, [(0.06, 0.91), (0.15, 0.97), (0.16, 0.985), (0.13, 0.965), (0, 0.93)], 20)
    fruit = (Surface("apple", (0.75, 0.22, 0.17), 0.5), Surface("lemon", (0.93, 0.80, 0.28), 0.5))
    for n, (x, z) in enumerate(((0.36, 0.03), (0.44, 0.04), (0.4, -0.05))):
        k.of(fruit[n % 2]).ball(x, 0.99, z, 0.042, 10, 6)
    return k


MODELS = (counter, corner_counter, sink, stove, fridge, cupboard, wall_cupboard, hood, dishwasher, kitchen_island)
