"""Furniture of schools."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
FRAME = Surface("blue frame", (0.24, 0.38, 0.52), 0.4)
PLYWOOD = Surface("plywood", (0.86, 0.74, 0.55), 0.5)


def school_desk():
    """A pupil sits at its front."""
    d = Model("school_desk")
    d.of(PLYWOOD).soft_block((-0.35, 0.7, -0.25), (0.35, 0.725, 0.25), 0.008)
    d.of(FRAME).block((-0.31, 0.62, -0.21), (0.31, 0.64, 0.21)).block((-0.31, 0.64, -0.21), (0.31, 0.7, -0.2))
    for s in SIDES:
        d.rod((s * 0.31, 0, -0.2), (s * 0.31, 0.7, -0.2), 0.014, 8).rod((s * 0.31, 0, 0.2), (s * 0.31, 0.7, 0.2), 0.014, 8)
        d.rod((s * 0.31, 0.08, -0.2), (s * 0.31, 0.08, 0.2), 0.012, 8)
    d.of(Surface("exercise book", (0.78, 0.33, 0.25), 0.9)).block((-0.2, 0.725, -0.04), (-0.04, 0.732, 0.18))
    d.of(WHITE).block((0.03, 0.725, -0.08), (0.24, 0.729, 0.19))
    return d.of(Surface("pencil", (0.93, 0.72, 0.22), 0.6)).rod((0.06, 0.729, -0.12), (0.22, 0.729, -0.13), 0.004, 6)


def school_desk_double():
    d = Model("school_desk_double")
    d.of(PLYWOOD).soft_block((-0.65, 0.7, -0.25), (0.65, 0.725, 0.25), 0.008)
    d.of(FRAME).block((-0.6, 0.62, -0.21), (0.6, 0.64, 0.21)).block((-0.6, 0.64, -0.21), (0.6, 0.7, -0.2))
    for s in SIDES:
        for z in (-0.2, 0.2):
            d.rod((s * 0.6, 0, z), (s * 0.6, 0.7, z), 0.014, 8)
        d.rod((s * 0.6, 0.08, -0.2), (s * 0.6, 0.08, 0.2), 0.012, 8)
        d.of(Surface("exercise book", (0.78, 0.33, 0.25), 0.9)).block((s * 0.3 - 0.2, 0.725, -0.05), (s * 0.3 - 0.04, 0.732, 0.17))
        d.of(WHITE).block((s * 0.3 + 0.02, 0.725, -0.07), (s * 0.3 + 0.22, 0.729, 0.19)).of(FRAME)
    return d


def school_chair():
    c = Model("school_chair")
    c.of(PLYWOOD).soft_block((-0.19, 0.43, -0.18), (0.19, 0.447, 0.2), 0.008)
    c.at(g.leaning(10, 0.45, -0.19)).soft_block((-0.19, 0.62, -0.205), (0.19, 0.8, -0.19), 0.007)
    c.of(FRAME)
    for s in SIDES:
        c.at(g.leaning(10, 0.45, -0.19)).rod((s * 0.165, 0.42, -0.185), (s * 0.165, 0.78, -0.185), 0.01, 8)
        c.at().rod((s * 0.165, 0.43, -0.18), (s * 0.185, 0, -0.23), 0.01, 8)
        c.rod((s * 0.165, 0.43, 0.17), (s * 0.185, 0, 0.2), 0.01, 8)
        c.rod((s * 0.165, 0.425, -0.19), (s * 0.165, 0.425, 0.18), 0.01, 8)
    return c


def teacher_desk():
    """The teacher sits at its front."""
    d = Model("teacher_desk")
    d.of(OAK).soft_block((-0.8, 0.71, -0.38), (0.8, 0.745, 0.38), 0.008)
    d.block((-0.76, 0.18, -0.3), (0.76, 0.71, -0.28))
    for s in SIDES:
        d.block((s * 0.75 - 0.02, 0, -0.34), (s * 0.75 + 0.02, 0.71, 0.34))
    d.block((0.3, 0.12, -0.28), (0.73, 0.71, 0.33))
    for i in range(3):
        d.of(BIRCH).soft_block((0.31, 0.13 + i * 0.19, 0.33), (0.72, 0.31 + i * 0.19, 0.345), 0.004)
        d.of(DARK).block((0.45, 0.24 + i * 0.19, 0.345), (0.58, 0.255 + i * 0.19, 0.36))
    colors = (Surface("red book", (0.66, 0.25, 0.20), 0.8), Surface("blue book", (0.22, 0.36, 0.52), 0.8))
    for i in range(4):
        d.of(colors[i % 2]).block((-0.62 + 0.01 * i, 0.745 + i * 0.03, -0.3), (-0.4 - 0.008 * i, 0.774 + i * 0.03, -0.02))
    d.of(Surface("apple", (0.75, 0.22, 0.17), 0.5)).ball(-0.2, 0.785, -0.12, 0.04, 12, 8)
    return d


def blackboard():
    """To be placed at a height of 0.8 m, its back to a wall."""
    b = Model("blackboard")
    b.of(Surface("slate", (0.14, 0.28, 0.23), 0.9)).block((-1.46, 0.06, -0.02), (1.46, 1.16, 0.012))
    b.of(OAK)
    for y in (0.0, 1.15):
        b.soft_block((-1.5, y, -0.025), (1.5, y + 0.06, 0.03), 0.005)
    for x in (-1.48, 0, 1.48):
        b.block((x - 0.02, 0.05, -0.025), (x + 0.02, 1.16, 0.028 if x else 0.018))
    b.soft_block((-1.2, 0.0, 0.03), (1.2, 0.022, 0.12), 0.005)
    b.of(Surface("chalk", (0.95, 0.95, 0.93), 1))
    for x in (-0.5, -0.38, 0.6):
        b.block((x, 0.022, 0.06), (x + 0.08, 0.034, 0.072))
    for i, long in enumerate((0.7, 0.5, 0.62)):  # lines of writing
        b.block((-1.25, 0.95 - i * 0.16, 0.012), (-1.25 + long, 0.967 - i * 0.16, 0.014))
    return b


def globe():
    m = Model("globe", "none", keeps_proportions=True)
    m.of(Surface("sea", (0.27, 0.50, 0.68), 0.4)).ball(0, 0.31, 0, 0.16, 24, 14)
    m.of(LEAVES)
    for turn, lift, squash in ((20, 25, 0.9), (100, -15, 1.1), (170, 30, 0.7), (250, 0, 1.2), (310, -30, 0.7)):
        m.at(g.turned_x(90 - lift), g.turned_y(turn), g.moved(0, 0.31, 0))
        m.turned(0, 0, [(0.075, 0.142 * 1), (0.05 * squash, 0.156), (0, 0.163)], 9)
    m.at().of(BRASS).turned(0, 0, [(0.1, 0), (0.1, 0.012), (0.02, 0.03), (0.012, 0.13), (0.03, 0.15)], 16)
    return m


def locker():
    m = Model("locker")
    m.of(FRAME).soft_block((-0.3, 0, -0.25), (0.3, 1.8, 0.23), 0.006)
    for s in SIDES:
        m.soft_block((s * 0.15 - 0.143, 0.06, 0.23), (s * 0.15 + 0.143, 1.77, 0.25), 0.006)
    m.of(DARK)
    for s in SIDES:
        for i in range(4):
            m.block((s * 0.15 - 0.07, 1.5 + i * 0.05, 0.25), (s * 0.15 + 0.07, 1.512 + i * 0.05, 0.252))
        m.block((s * 0.15 + 0.09, 0.95, 0.25), (s * 0.15 + 0.11, 1.08, 0.265))
    return m


MODELS = (school_desk, school_desk_double, school_chair, teacher_desk, blackboard, globe, locker)
