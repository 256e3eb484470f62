"""Tiles of streets, ten metres square: 6 m of asphalt between two pavements of 2 m."""
import geometry as g
from model import Model
from surfaces import *

SIDES = (-1, 1)
PAVEMENT = Surface("pavement", (0.74, 0.73, 0.70), 0.95)
KERB = Surface("kerb", (0.60, 0.59, 0.57), 0.95)


def _roadway(model, low, high):
    model.of(ASPHALT).block((low[0], 0, low[1]), (high[0], 0.05, high[1]))


def _pavement(model, low, high):
    model.of(PAVEMENT).block((low[0], 0, low[1]), (high[0], 0.17, high[1]))


def _kerb(model, low, high):
    model.of(KERB).block((low[0], 0, low[1]), (high[0], 0.18, high[1]))


def _dashes(model, along_x, start, end):
    model.of(MARKING)
    for i in range(3):
        a = start + (end - start) * (i + 0.2) / 3
        b = start + (end - start) * (i + 0.7) / 3
        low, high = ((a, -0.08), (b, 0.08)) if along_x else ((-0.08, a), (0.08, b))
        model.block((low[0], 0.05, low[1]), (high[0], 0.055, high[1]))


def _side(model, turn, length=5):
    """A pavement along the side x = 3..5, turned about the centre."""
    model.at(g.turned_y(turn))
    _pavement(model, (3.15, -length), (5, length))
    _kerb(model, (3, -length), (3.15, length))
    model.at()


def _corner(model, turn):
    """The corner of a pavement between two streets that meet."""
    model.at(g.turned_y(turn))
    _pavement(model, (3.15, 3.15), (5, 5))
    _kerb(model, (3, 3), (3.15, 5))
    _kerb(model, (3.15, 3), (5, 3.15))
    model.at()


def street():
    """Straight, from its front to its back."""
    m = Model("street")
    _roadway(m, (-3, -5), (3, 5))
    _side(m, 0)
    _side(m, 180)
    _dashes(m, False, -5, 5)
    return m


def street_corner():
    """From its front to its right."""
    m = Model("street_corner")
    _roadway(m, (-3, -3), (5, 3))
    _roadway(m, (-3, 3), (3, 5))
    _side(m, 180)
    _side(m, 90)
    _corner(m, 0)
    return m


def street_tee():
    """From its left to its right, with a street to its front."""
    m = Model("street_tee")
    _roadway(m, (-5, -3), (5, 3))
    _roadway(m, (-3, 3), (3, 5))
    _side(m, 90)
    _corner(m, 0)
    _corner(m, -90)
    return m


def street_crossing():
    m = Model("street_crossing")
    _roadway(m, (-5, -3), (5, 3))
    for s in SIDES:
        _roadway(m, (-3, min(3 * s, 5 * s)), (3, max(3 * s, 5 * s)))
    for turn in (0, 90, 180, 270):
        _corner(m, turn)
        m.at(g.turned_y(turn)).of(MARKING)
        for i in range(6):
            m.block((-2.6 + i, 0.05, 3.4), (-2.1 + i, 0.055, 4.7))
        m.at()
    return m


def street_end():
    """From its front, where one turns round."""
    m = Model("street_end")
    _roadway(m, (-3, -3), (3, 5))
    _side(m, 0)
    _side(m, 180)
    m.of(PAVEMENT).block((-3, 0, -5), (3, 0.17, -3.15))
    _kerb(m, (-3, -3.15), (3, -3))
    return m


def street_with_crosswalk():
    m = street()
    m.name = "street_with_crosswalk"
    m.parts = [part for part in m.parts if part.surface != MARKING]
    m.of(MARKING)
    for i in range(6):
        m.block((-2.6 + i, 0.05, -1.5), (-2.1 + i, 0.055, 1.5))
    return m


def lawn():
    return Model("lawn", "none").of(GRASS).block((-5, 0, -5), (5, 0.15, 5))


def plaza():
    m = Model("plaza", "none").of(PAVEMENT)
    for i in range(5):
        for k in range(5):
            m.soft_block((-5 + i * 2 + 0.02, 0, -5 + k * 2 + 0.02), (-3 + i * 2 - 0.02, 0.17, -3 + k * 2 - 0.02), 0.015)
    return m.of(KERB).block((-5, 0, -5), (5, 0.15, 5))


def parking_space():
    """Cars come in from its front."""
    m = Model("parking_space").of(ASPHALT).block((-1.25, 0, -2.5), (1.25, 0.05, 2.5))
    m.of(MARKING)
    for s in SIDES:
        x0, x1 = sorted((s * 1.25, s * 1.19))
        m.block((x0, 0.05, -2.5), (x1, 0.055, 2.5))
    return m.block((-1.19, 0.05, -2.5), (1.19, 0.055, -2.44))


MODELS = (street, street_corner, street_tee, street_crossing, street_end, street_with_crosswalk, lawn, plaza,
          parking_space)
