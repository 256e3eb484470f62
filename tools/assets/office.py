"""Furniture of offices."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)


def desk():
    """Whoever works at it sits at its front, where the drawers open."""
    d = Model("desk")
    d.of(BIRCH).soft_block((-0.7, 0.71, -0.35), (0.7, 0.74, 0.35), 0.006)
    d.block((-0.66, 0.35, -0.31), (0.24, 0.7, -0.29))
    d.of(WHITE).block((0.24, 0.06, -0.3), (0.66, 0.71, 0.3))
    d.of(DARK)
    for s in SIDES:
        d.post(-0.64, s * 0.3, 0, 0.04, 0.04, 0.71, 0.04, 0.04)
    d.block((-0.66, 0, -0.32), (-0.62, 0.04, 0.32)).block((0.27, 0, -0.27), (0.63, 0.06, 0.27))
    for i in range(3):
        y = 0.08 + i * 0.208
        d.of(WHITE).soft_block((0.25, y, 0.3), (0.65, y + 0.2, 0.318), 0.004)
        d.of(DARK).block((0.38, y + 0.14, 0.318), (0.52, y + 0.155, 0.335))
    return d


def _screen(model, x, y, z):
    model.of(BLACK).soft_block((x - 0.27, y + 0.12, z - 0.02), (x + 0.27, y + 0.45, z + 0.012), 0.006)
    model.of(SCREEN).block((x - 0.26, y + 0.13, z + 0.012), (x + 0.26, y + 0.44, z + 0.014))
    model.of(BLACK).block((x - 0.02, y + 0.01, z - 0.03), (x + 0.02, y + 0.25, z - 0.02))
    model.soft_block((x - 0.11, y, z - 0.09), (x + 0.11, y + 0.012, z + 0.07), 0.004)


def computer_desk():
    """A desk with a computer on it."""
    d = desk()
    d.name = "computer_desk"
    _screen(d, -0.1, 0.74, -0.18)
    d.of(DARK).soft_block((-0.32, 0.74, 0.06), (0.1, 0.76, 0.2), 0.006)
    d.of(WHITE).soft_block((-0.31, 0.758, 0.07), (0.09, 0.765, 0.19), 0.003)
    d.of(BLACK).soft_block((0.17, 0.74, 0.1), (0.23, 0.765, 0.2), 0.012)
    d.of(Surface("cup", (0.75, 0.33, 0.26), 0.4)).turned(0.45, -0.15, [(0.035, 0.74), (0.042, 0.83), (0.034, 0.82), (0, 0.75)], 14)
    d.of(WHITE).block((0.35, 0.74, 0.02), (0.58, 0.752, 0.26))
    return d


def computer():
    """Stands on a desk."""
    c = Model("computer")
    _screen(c, 0, 0, -0.1)
    c.of(DARK).soft_block((-0.22, 0, 0.08), (0.2, 0.02, 0.22), 0.006)
    c.of(WHITE).soft_block((-0.21, 0.018, 0.09), (0.19, 0.025, 0.21), 0.003)
    return c


def office_chair():
    c = Model("office_chair")
    c.of(GREY).soft_block((-0.25, 0.45, -0.22), (0.25, 0.52, 0.27), 0.03)
    lean = g.leaning(9, 0.5, -0.22)
    c.at(lean).soft_block((-0.23, 0.6, -0.27), (0.23, 1.08, -0.21), 0.027)
    c.at().of(BLACK).block((-0.16, 0.42, -0.16), (0.16, 0.45, 0.2))
    c.at(lean).block((-0.03, 0.42, -0.31), (0.03, 0.85, -0.27)).at().block((-0.03, 0.42, -0.3), (0.03, 0.445, -0.16))
    for s in SIDES:
        c.block((s * 0.275 - 0.012, 0.44, -0.06), (s * 0.275 + 0.012, 0.66, 0.0))
        c.block((s * 0.21 - 0.075, 0.43, -0.06), (s * 0.21 + 0.075, 0.45, 0.0))
        c.soft_block((s * 0.275 - 0.035, 0.66, -0.14), (s * 0.275 + 0.035, 0.69, 0.14), 0.012)
    for i in range(5):
        c.at(g.turned_y(i * 72)).block((-0.025, 0.07, 0.02), (0.025, 0.105, 0.3))
        c.turned(0, 0.28, [(0.018, 0.05), (0.018, 0.075)], 8).soft_block((-0.03, 0, 0.252), (0.03, 0.055, 0.308), 0.014)
    return c.at().of(STEEL).turned(0, 0, [(0.045, 0.06), (0.045, 0.2), (0.028, 0.2), (0.028, 0.42)], 16)


def whiteboard():
    w = Model("whiteboard")
    w.of(Surface("board", (0.97, 0.97, 0.98), 0.25)).block((-0.87, 0.83, -0.012), (0.87, 1.87, 0.014))
    w.of(STEEL)
    for y in (0.8, 1.87):
        w.block((-0.9, y, -0.02), (0.9, y + 0.03, 0.02))
    for s in SIDES:
        w.block((s * 0.885 - 0.015, 0.8, -0.02), (s * 0.885 + 0.015, 1.9, 0.02))
        w.block((s * 0.82 - 0.02, 0.06, -0.02), (s * 0.82 + 0.02, 0.8, 0.02))
        w.block((s * 0.82 - 0.025, 0.06, -0.27), (s * 0.82 + 0.025, 0.1, 0.27))
    w.block((-0.82, 0.3, -0.015), (0.82, 0.34, 0.015)).block((-0.6, 0.795, 0.02), (0.6, 0.81, 0.09))
    w.of(BLACK)
    for s in SIDES:
        for t in SIDES:
            w.block((s * 0.82 - 0.015, 0, t * 0.24 - 0.03), (s * 0.82 + 0.015, 0.06, t * 0.24 + 0.03))
    w.of(Surface("pens", (0.16, 0.30, 0.62), 0.5)).block((-0.2, 0.81, 0.04), (-0.06, 0.825, 0.055))
    return w.block((0.05, 0.81, 0.04), (0.19, 0.825, 0.055))


def meeting_table():
    t = Model("meeting_table", "none")
    outline = [(-1.2, -0.42), (-0.9, -0.55), (0.9, -0.55), (1.2, -0.42), (1.2, 0.42), (0.9, 0.55), (-0.9, 0.55), (-1.2, 0.42)]
    t.of(OAK).at(g.turned_x(-90)).extruded(outline, 0.7, 0.74)
    t.at().of(DARK)
    for s in SIDES:
        t.block((s * 0.75 - 0.03, 0.02, -0.3), (s * 0.75 + 0.03, 0.7, 0.3)).soft_block((s * 0.75 - 0.06, 0, -0.42), (s * 0.75 + 0.06, 0.03, 0.42), 0.008)
    t.block((-0.72, 0.62, -0.02), (0.72, 0.68, 0.02))
    return t.of(BLACK).soft_block((-0.25, 0.74, -0.06), (0.25, 0.745, 0.06), 0.002)


def filing_cabinet():
    f = Model("filing_cabinet")
    f.of(Surface("sheet metal", (0.70, 0.73, 0.75), 0.4)).soft_block((-0.23, 0, -0.3), (0.23, 1.32, 0.28), 0.006)
    for i in range(4):
        y = 0.03 + i * 0.32
        f.of(Surface("sheet metal", ())).soft_block((-0.22, y, 0.28), (0.22, y + 0.31, 0.3), 0.006)
        f.of(STEEL).block((-0.07, y + 0.14, 0.3), (0.07, y + 0.16, 0.325))
        f.of(WHITE).block((-0.05, y + 0.2, 0.3), (0.05, y + 0.25, 0.304))
    return f


def printer():
    p = Model("printer")
    p.of(Surface("printer", (0.88, 0.88, 0.87), 0.5)).soft_block((-0.3, 0.5, -0.28), (0.3, 0.88, 0.26), 0.015)
    p.soft_block((-0.3, 0.94, -0.28), (0.3, 1.08, 0.24), 0.02)
    p.of(DARK).block((-0.28, 0.88, -0.26), (0.28, 0.94, 0.1)).soft_block((-0.3, 0.03, -0.28), (0.3, 0.5, 0.25), 0.01)
    p.of(WHITE).block((-0.15, 0.885, -0.1), (0.1, 0.9, 0.2))
    for i in range(2):
        p.of(Surface("printer", ())).soft_block((-0.28, 0.06 + i * 0.22, 0.25), (0.28, 0.26 + i * 0.22, 0.265), 0.005)
    p.of(SCREEN).at(g.turned_x(35), g.moved(0.16, 1.05, 0.25)).soft_block((-0.11, -0.02, -0.06), (0.11, 0.01, 0.06), 0.005)
    return p.at().of(BLACK).legs(0.5, 0.44, 0.03, 0.06, 0.06)


def partition():
    p = Model("partition")
    p.of(GREY).soft_block((-0.72, 0.15, -0.02), (0.72, 1.38, 0.02), 0.01)
    p.of(STEEL).block((-0.74, 1.38, -0.025), (0.74, 1.41, 0.025)).block((-0.74, 0.12, -0.025), (0.74, 0.15, 0.025))
    for s in SIDES:
        p.block((s * 0.73 - 0.015, 0.03, -0.025), (s * 0.73 + 0.015, 1.41, 0.025)).soft_block((s * 0.7 - 0.03, 0, -0.22), (s * 0.7 + 0.03, 0.03, 0.22), 0.008)
    return p


def water_cooler():
    w = Model("water_cooler")
    w.of(WHITE).soft_block((-0.16, 0, -0.16), (0.16, 0.95, 0.16), 0.02)
    w.of(DARK).block((-0.11, 0.55, 0.155), (0.11, 0.8, 0.163)).soft_block((-0.1, 0.5, 0.16), (0.1, 0.53, 0.24), 0.006)
    for s, color in ((-1, (0.75, 0.22, 0.2)), (1, (0.2, 0.4, 0.7))):
        w.of(Surface("tap red" if s < 0 else "tap blue", color, 0.4)).soft_block((s * 0.05 - 0.018, 0.7, 0.163), (s * 0.05 + 0.018, 0.76, 0.21), 0.005)
    w.of(Surface("bottle", (0.55, 0.74, 0.86), 0.05)).turned(
        0, 0, [(0.05, 0.95), (0.06, 0.99), (0.135, 1.05), (0.135, 1.18), (0.125, 1.2), (0.135, 1.22), (0.135, 1.34), (0.1, 1.38)], 20)
    return w


MODELS = (desk, computer_desk, computer, office_chair, whiteboard, meeting_table, filing_cabinet, printer, partition,
          water_cooler)
