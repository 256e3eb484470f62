"""What grows and stands along streets and in parks."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)


def _crown(model, x, z, y, r):
    model.ball(x, y, z, r, 12, 6, 0.9)


def tree():
    t = Model("tree", "none", keeps_proportions=True).of(LEAVES)
    for x, z, y, r in ((0, 0, 3.0, 1.0), (0.55, 0.2, 2.45, 0.65), (-0.5, 0.35, 2.6, 0.7), (-0.1, -0.55, 2.5, 0.65)):
        _crown(t, x, z, y, r)
    return t.of(BARK).turned(0, 0, [(0.2, 0), (0.14, 0.25), (0.11, 1.6), (0.07, 2.8)], 12)


def tall_tree():
    t = Model("tall_tree", "none", keeps_proportions=True).of(Surface("dark leaves", (0.23, 0.43, 0.22), 0.9))
    for x, z, y, r in ((0, 0, 6.2, 1.7), (1.1, 0.3, 5.0, 1.3), (-1.0, 0.5, 5.1, 1.4), (-0.1, -1.1, 4.9, 1.3), (0.3, 1.0, 4.5, 1.1)):
        _crown(t, x, z, y, r)
    t.of(BARK).turned(0, 0, [(0.42, 0), (0.28, 0.5), (0.22, 3), (0.12, 5.5)], 12)
    return t.rod((0, 2.6, 0), (1.0, 4.4, 0.3), 0.1, 8, 0.05).rod((0, 2.9, 0), (-0.9, 4.5, 0.5), 0.1, 8, 0.05)


def fir_tree():
    t = Model("fir_tree", "none", keeps_proportions=True).of(NEEDLES)
    for y, r, h in ((0.9, 1.35, 1.9), (2.0, 1.1, 1.7), (3.0, 0.85, 1.5), (3.9, 0.58, 1.6)):
        t.turned(0, 0, [(r * 0.25, y + 0.15), (r, y), (0, y + h)], 14)
    return t.of(BARK).turned(0, 0, [(0.18, 0), (0.14, 1.3)], 10)


def hedge():
    h = Model("hedge", "none").of(LEAVES).soft_block((-1, 0, -0.3), (1, 1.0, 0.3), 0.08)
    for i in range(5):
        h.soft_block((-0.96 + i * 0.4, 0.1, -0.33), (-0.64 + i * 0.4, 0.9, 0.33), 0.05)
    return h


def flower_bed():
    f = Model("flower_bed", "none").of(Surface("flowers", (0.88, 0.36, 0.42), 0.9))
    for i in range(4):
        for k in range(3):
            x, z = -0.72 + i * 0.48 + 0.1 * (k % 2), -0.27 + k * 0.27
            f.of(Surface("flowers", ()) if (i + k) % 2 else Surface("yellow flowers", (0.95, 0.79, 0.30), 0.9)).ball(x, 0.34, z, 0.1, 8, 5)
            f.of(LEAVES).turned(x, z, [(0.13, 0.12), (0.1, 0.22), (0.03, 0.32)], 6)
    f.of(SOIL).block((-0.95, 0, -0.45), (0.95, 0.13, 0.45)).of(STONE)
    for s in SIDES:
        f.soft_block((-1, 0, s * 0.475 - 0.025), (1, 0.17, s * 0.475 + 0.025), 0.01).block((s * 0.975 - 0.025, 0, -0.45), (s * 0.975 + 0.025, 0.165, 0.45))
    return f


def street_lamp():
    """Leans out over its front."""
    m = Model("street_lamp", keeps_proportions=True).of(DARK)
    m.turned(0, 0, [(0.16, 0), (0.16, 0.1), (0.09, 0.2), (0.07, 0.9), (0.05, 4.9)], 12)
    m.rod((0, 4.8, 0), (0, 5.2, 0.25), 0.045, 8).rod((0, 5.2, 0.25), (0, 5.25, 1.0), 0.04, 8)
    m.soft_block((-0.11, 5.18, 0.7), (0.11, 5.3, 1.35), 0.03)
    return m.of(Surface("lamp", (1, 0.94, 0.76), 0.4, 0, 0.8)).block((-0.08, 5.165, 0.78), (0.08, 5.18, 1.3))


def traffic_light():
    m = Model("traffic_light", keeps_proportions=True).of(DARK)
    m.turned(0, 0, [(0.12, 0), (0.12, 0.08), (0.05, 0.12), (0.05, 2.5)], 12).soft_block((-0.16, 2.3, -0.1), (0.16, 3.25, 0.12), 0.03)
    for y, name, color in ((3.08, "red light", (0.9, 0.15, 0.12)), (2.78, "amber light", (0.95, 0.65, 0.15)), (2.48, "green light", (0.2, 0.75, 0.3))):
        m.of(Surface(name, color, 0.3, 0, 0.5)).at(g.turned_x(90), g.moved(0, y, 0.12)).turned(0, 0, [(0.1, 0), (0.08, 0.02), (0, 0.03)], 14)
        m.at().of(DARK).soft_block((-0.12, y + 0.1, 0.12), (0.12, y + 0.125, 0.28), 0.005)
    return m


def bench():
    b = Model("bench").of(OAK)
    for i in range(4):
        b.soft_block((-0.8, 0.42, -0.2 + i * 0.11), (0.8, 0.455, -0.11 + i * 0.11), 0.008)
    b.at(g.leaning(14, 0.45, -0.22))
    for i in range(3):
        b.soft_block((-0.8, 0.54 + i * 0.12, -0.25), (0.8, 0.63 + i * 0.12, -0.22), 0.008)
    b.of(DARK)
    for s in SIDES:
        b.at(g.leaning(14, 0.45, -0.22)).block((s * 0.6 - 0.025, 0.4, -0.275), (s * 0.6 + 0.025, 0.86, -0.25))
        b.at().block((s * 0.6 - 0.025, 0.38, -0.24), (s * 0.6 + 0.025, 0.42, 0.22))
        for z in (-0.2, 0.18):
            b.block((s * 0.6 - 0.025, 0, z - 0.025), (s * 0.6 + 0.025, 0.38, z + 0.025))
    return b.at()


def litter_bin():
    b = Model("litter_bin", "none", keeps_proportions=True).of(Surface("bin", (0.22, 0.40, 0.32), 0.6))
    return b.turned(0, 0, [(0.2, 0.05), (0.25, 0.1), (0.25, 0.8), (0.27, 0.82), (0.27, 0.88), (0.2, 0.9)], 18).of(BLACK).turned(
        0, 0, [(0.19, 0.895), (0.19, 0.903)], 16).of(DARK).turned(0, 0, [(0.15, 0), (0.15, 0.06)], 12)


def fence():
    """Two metres of pales."""
    f = Model("fence").of(WHITE)
    for i in range(10):
        x = -0.9 + i * 0.2
        f.extruded([(x - 0.06, 0.05), (x + 0.06, 0.05), (x + 0.06, 0.9), (x, 1.0), (x - 0.06, 0.9)], 0.02, 0.045)
    for y in (0.25, 0.7):
        f.block((-1, y, -0.02), (1, y + 0.08, 0.02))
    for s in SIDES:
        f.soft_block((s * 0.96 - 0.04, 0, -0.04), (s * 0.96 + 0.04, 1.05, 0.02), 0.01)
    return f


def fountain():
    f = Model("fountain", "none", keeps_proportions=True).of(STONE)
    f.turned(0, 0, [(2.0, 0), (2.0, 0.4), (2.1, 0.42), (2.1, 0.55), (1.8, 0.55), (1.8, 0.3)], 32)
    f.turned(0, 0, [(0.5, 0.3), (0.3, 0.5), (0.22, 1.2), (0.9, 1.45), (0.95, 1.6), (0.8, 1.6), (0.6, 1.5)], 24)
    f.turned(0, 0, [(0.15, 1.5), (0.12, 2.0), (0.4, 2.15), (0.42, 2.25), (0.3, 2.22)], 18)
    return f.of(WATER).turned(0, 0, [(1.8, 0.3), (1.8, 0.42)], 32).turned(0, 0, [(0.8, 1.5), (0.8, 1.56)], 24).turned(
        0, 0, [(0.34, 2.15), (0.34, 2.235), (0.05, 2.26), (0.03, 2.6), (0, 2.65)], 14)


def bus_stop():
    b = Model("bus_stop").of(DARK)
    for s in SIDES:
        for z in (-0.7, 0.5):
            b.block((s * 1.9 - 0.04, 0, z - 0.04), (s * 1.9 + 0.04, 2.4, z + 0.04))
    b.soft_block((-2.1, 2.4, -0.85), (2.1, 2.5, 0.75), 0.02)
    b.of(GLASS).block((-1.86, 0.2, -0.72), (1.86, 2.3, -0.7)).block((1.89, 0.2, -0.66), (1.91, 2.3, 0.46))
    b.of(OAK).soft_block((-1.2, 0.42, -0.6), (1.2, 0.47, -0.2), 0.01).of(DARK)
    for s in SIDES:
        b.block((s * 1.0 - 0.03, 0, -0.45), (s * 1.0 + 0.03, 0.42, -0.35))
    return b.of(Surface("sign blue", (0.16, 0.36, 0.66), 0.5)).soft_block((-1.95, 1.8, 0.45), (-1.85, 2.3, 0.95), 0.02)


def person():
    """An adult of 1.75 m, for scale."""
    p = Model("person", keeps_proportions=True)
    p.of(Surface("pullover", (0.72, 0.33, 0.27), 0.95)).turned(0, 0, [(0.15, 0.85), (0.17, 1.1), (0.19, 1.35), (0.08, 1.48)], 14)
    for s in SIDES:
        p.of(Surface("pullover", ())).rod((s * 0.19, 1.4, 0), (s * 0.26, 0.95, 0.03), 0.05, 8)
        p.of(SKIN).ball(s * 0.265, 0.89, 0.04, 0.055, 8, 5)
        p.of(Surface("trousers", (0.24, 0.28, 0.38), 0.9)).rod((s * 0.09, 0.9, 0), (s * 0.1, 0.06, 0), 0.085, 10, 0.06)
        p.of(BARK).soft_block((s * 0.1 - 0.055, 0, -0.1), (s * 0.1 + 0.055, 0.09, 0.18), 0.02)
    p.of(SKIN).turned(0, 0, [(0.05, 1.44), (0.05, 1.54)], 10).ball(0, 1.62, 0, 0.115, 12, 8, 1.12)
    return p.of(Surface("hair", (0.25, 0.17, 0.12), 0.9)).ball(0, 1.655, -0.022, 0.118, 12, 8, 1.0)


MODELS = (tree, tall_tree, fir_tree, hedge, flower_bed, street_lamp, traffic_light, bench, litter_bin, fence, fountain,
          bus_stop, person)
