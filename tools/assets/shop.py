"""Furniture of shops."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)


def shop_shelf():
    """A shelf with goods, which a program's colour paints."""
    m = Model("shop_shelf").of(Surface("goods", (0.85, 0.55, 0.30), 0.7))
    for row in range(4):
        y, n = 0.16 + row * 0.36, 7 + row % 2 * 2
        each = 1.2 / n
        for i in range(n):
            x = -0.6 + i * each
            tall = 0.2 + 0.03 * ((i * 3 + row * 2) % 4)
            m.soft_block((x + 0.012, y, -0.14), (x + each - 0.012, y + tall, 0.19), 0.01)
    m.of(WHITE)
    for row in range(5):
        m.soft_block((-0.62, 0.12 + row * 0.36, -0.22), (0.62, 0.155 + row * 0.36, 0.23), 0.006)
    m.block((-0.62, 0.12, -0.23), (0.62, 1.68, -0.21))
    m.of(STEEL)
    for s in SIDES:
        m.block((s * 0.611 - 0.014, 0, -0.236), (s * 0.611 + 0.014, 1.7, -0.18)).block(
            (s * 0.611 - 0.014, 0, -0.2), (s * 0.611 + 0.014, 0.12, 0.232))
    return m


def till():
    """Who works here stands behind it."""
    m = Model("till").of(OAK).soft_block((-0.6, 0, -0.28), (0.6, 0.88, 0.28), 0.012)
    m.of(DARK).soft_block((-0.62, 0.88, -0.3), (0.62, 0.92, 0.3), 0.008).block((-0.5, 0.921, -0.12), (0.2, 0.926, 0.16))
    m.of(BLACK).soft_block((0.26, 0.92, -0.16), (0.54, 1.02, 0.14), 0.012)
    m.at(g.turned_x(25), g.moved(0.4, 1.16, -0.04)).soft_block((-0.15, -0.12, -0.015), (0.15, 0.12, 0.015), 0.006)
    m.of(SCREEN).block((-0.13, -0.1, -0.019), (0.13, 0.1, -0.015))
    return m.at().of(STEEL).rod((0.4, 1.0, -0.02), (0.4, 1.12, -0.03), 0.02, 8)


MODELS = (shop_shelf, till)
