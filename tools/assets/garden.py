"""Plants of a vegetable garden."""
import math

from model import Model
from surfaces import *


def _tuft(model, count, reach, height, root=0.0, width=0.05):
    for i in range(count):
        a = i * 2.399963
        x, z = math.sin(a), math.cos(a)
        model.leaf((x * 0.01, root, z * 0.01), (x * reach * 0.5, root + height * 0.7, z * reach * 0.5),
                   (x * reach, root + height * (0.75 + 0.05 * (i % 5)), z * reach), width)


def carrot():
    m = Model("carrot", "none", keeps_proportions=True).of(LEAVES)
    _tuft(m, 9, 0.14, 0.34, 0.03, 0.05)
    return m.of(Surface("carrot", (0.93, 0.49, 0.15), 0.7)).turned(0, 0, [(0.045, 0), (0.055, 0.03), (0.03, 0.06), (0, 0.065)], 12)


def onion():
    m = Model("onion", "none", keeps_proportions=True).of(Surface("onion leaves", (0.42, 0.62, 0.35), 0.8))
    for i in range(6):
        a = i * 2.399963
        m.rod((0.015 * math.sin(a), 0.06, 0.015 * math.cos(a)), (0.1 * math.sin(a), 0.36 - 0.02 * i, 0.1 * math.cos(a)), 0.012, 6, 0.003)
    return m.of(Surface("onion", (0.85, 0.70, 0.48), 0.5)).turned(0, 0, [(0.04, 0), (0.075, 0.035), (0.06, 0.07), (0.015, 0.1), (0, 0.105)], 14)


def bean():
    """Climbs a pole."""
    m = Model("bean", "none", keeps_proportions=True).of(LEAVES)
    for i in range(26):
        a, y = i * 1.3, 0.06 + i * 0.04
        x, z = math.sin(a), math.cos(a)
        m.leaf((x * 0.02, y, z * 0.02), (x * 0.09, y + 0.06, z * 0.09), (x * 0.16, y + 0.02, z * 0.16), 0.1)
    m.of(Surface("bean", (0.55, 0.72, 0.25), 0.7))
    for i in range(7):
        a, y = i * 2.4, 0.3 + i * 0.1
        m.rod((0.09 * math.sin(a), y, 0.09 * math.cos(a)), (0.11 * math.sin(a), y - 0.14, 0.11 * math.cos(a)), 0.012, 6, 0.006)
    return m.of(OAK).rod((0, 0, 0), (0, 1.2, 0), 0.012, 6)


def tomato():
    m = Model("tomato", "none", keeps_proportions=True).of(LEAVES)
    for level in range(5):
        for i in range(5):
            a, y = i * 1.2566 + level * 0.6, 0.14 + level * 0.13
            x, z, r = math.sin(a), math.cos(a), 0.2 - level * 0.02
            m.leaf((x * 0.01, y, z * 0.01), (x * r * 0.6, y + 0.07, z * r * 0.6), (x * r, y + 0.01, z * r), 0.11)
    m.of(Surface("tomato", (0.85, 0.18, 0.13), 0.35))
    for i in range(8):
        a, y = i * 2.4, 0.16 + i * 0.065
        m.ball(0.12 * math.sin(a), y, 0.12 * math.cos(a), 0.042, 8, 6)
    return m.of(OAK).rod((0, 0, 0), (0, 0.85, 0), 0.012, 6)


def cabbage():
    m = Model("cabbage", "none", keeps_proportions=True).of(Surface("cabbage", (0.55, 0.72, 0.45), 0.8))
    m.ball(0, 0.11, 0, 0.11, 12, 8)
    for i in range(9):
        a = i * 2.399963
        x, z = math.sin(a), math.cos(a)
        m.leaf((x * 0.03, 0.01, z * 0.03), (x * 0.14, 0.07, z * 0.14), (x * 0.19, 0.14, z * 0.19), 0.17)
    return m


def raised_bed():
    """Of one metre, full of earth."""
    m = Model("raised_bed", "none").of(SOIL).block((-0.46, 0, -0.46), (0.46, 0.17, 0.46)).of(OAK)
    for s in (-1, 1):
        m.soft_block((-0.49, 0, s * 0.465 - 0.025), (0.49, 0.2, s * 0.465 + 0.025), 0.008)
        m.soft_block((s * 0.465 - 0.025, 0, -0.44), (s * 0.465 + 0.025, 0.2, 0.44), 0.008)
    return m


MODELS = (carrot, onion, bean, tomato, cabbage, raised_bed)
