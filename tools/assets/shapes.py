"""Plain shapes of one metre."""
from model import Model
import geometry as g
from surfaces import Surface

PLAIN = Surface("plain", (0.78, 0.76, 0.72), 0.8)


def cylinder():
    return Model("cylinder", "none").of(PLAIN).turned(0, 0, [(0.5, 0), (0.5, 1)], 32)


def cone():
    return Model("cone", "none").of(PLAIN).turned(0, 0, [(0.5, 0), (0, 1)], 32)


def sphere():
    return Model("sphere", "none", keeps_proportions=True).of(PLAIN).ball(0, 0.5, 0, 0.5, 24, 12)


def dome():
    """Half a sphere."""
    rings = [(0.5, 0), (0.483, 0.129), (0.433, 0.25), (0.354, 0.354), (0.25, 0.433), (0.129, 0.483), (0, 0.5)]
    return Model("dome", "none", keeps_proportions=True).of(PLAIN).turned(0, 0, rings, 24)


def disc():
    return Model("disc", "none").of(PLAIN).turned(0, 0, [(0.5, 0), (0.5, 0.02)], 48)


def pyramid():
    return Model("pyramid", "none").of(PLAIN).face(
        [(-0.5, 0, -0.5), (0.5, 0, -0.5), (0.5, 0, 0.5), (-0.5, 0, 0.5)]).face(
            [(-0.5, 0, 0.5), (0.5, 0, 0.5), (0, 1, 0)]).face([(0.5, 0, 0.5), (0.5, 0, -0.5), (0, 1, 0)]).face(
                [(0.5, 0, -0.5), (-0.5, 0, -0.5), (0, 1, 0)]).face([(-0.5, 0, -0.5), (-0.5, 0, 0.5), (0, 1, 0)])


def wedge():
    """Rises from its front to its back."""
    return Model("wedge").of(PLAIN).at(g.turned_y(90)).extruded([(-0.5, 0), (0.5, 0), (0.5, 1)], -0.5, 0.5)


def gable():
    """A roof whose ridge runs from left to right."""
    return Model("gable").of(PLAIN).at(g.turned_y(90)).extruded([(-0.5, 0), (0.5, 0), (0, 1)], -0.5, 0.5)


def arch():
    """A wall of one metre with a round-headed way through it."""
    import math
    inner = [(0.3 * math.cos(math.pi * i / 12), 0.5 + 0.3 * math.sin(math.pi * i / 12)) for i in range(13)]
    outline = [(-0.5, 1), (-0.5, 0), (-0.3, 0)] + inner[::-1] + [(0.3, 0), (0.5, 0), (0.5, 1)]
    return Model("arch").of(PLAIN).extruded(outline, -0.1, 0.1)


MODELS = (cylinder, cone, sphere, dome, disc, pyramid, wedge, gable, arch)
