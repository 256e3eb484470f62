"""What models are made of. Colours are red, green, blue, each 0..1, as screens show them."""
from typing import NamedTuple


class Surface(NamedTuple):
    name: str
    color: tuple
    roughness: float = 0.8
    metallic: float = 0
    glow: float = 0      # share of its colour that it emits
    opacity: float = 1


OAK = Surface("oak", (0.76, 0.58, 0.38), 0.65)
WALNUT = Surface("walnut", (0.45, 0.30, 0.20), 0.6)
BIRCH = Surface("birch", (0.87, 0.77, 0.62), 0.65)
PINE = Surface("pine", (0.85, 0.68, 0.45), 0.7)
STEEL = Surface("steel", (0.66, 0.68, 0.71), 0.35, 0.3)
CHROME = Surface("chrome", (0.80, 0.81, 0.83), 0.15, 0.6)
DARK = Surface("dark metal", (0.20, 0.21, 0.23), 0.5, 0.2)
BRASS = Surface("brass", (0.83, 0.66, 0.33), 0.35, 0.6)
GOLD = Surface("gold", (0.98, 0.78, 0.25), 0.3, 0.4)
WHITE = Surface("white", (0.93, 0.93, 0.91), 0.6)
ENAMEL = Surface("enamel", (0.96, 0.96, 0.95), 0.15)
GREY = Surface("grey fabric", (0.46, 0.52, 0.58), 0.95)
BLACK = Surface("black plastic", (0.13, 0.13, 0.14), 0.6)
LINEN = Surface("linen", (0.90, 0.88, 0.84), 0.95)
LEATHER = Surface("leather", (0.50, 0.24, 0.19), 0.5)
LEAVES = Surface("leaves", (0.27, 0.50, 0.24), 0.9)
NEEDLES = Surface("needles", (0.17, 0.37, 0.24), 0.9)
GRASS = Surface("grass", (0.44, 0.62, 0.30), 1)
SOIL = Surface("soil", (0.25, 0.18, 0.13), 1)
BARK = Surface("bark", (0.38, 0.28, 0.20), 1)
GLASS = Surface("glass", (0.66, 0.82, 0.90), 0.05, 0, 0, 0.35)
PANE = Surface("window pane", (0.35, 0.47, 0.56), 0.1)   # of buildings, into which nobody looks
SCREEN = Surface("screen", (0.10, 0.12, 0.16), 0.2)
WATER = Surface("water", (0.25, 0.52, 0.68), 0.08)
STONE = Surface("stone", (0.58, 0.56, 0.53), 0.95)
MORTAR = Surface("mortar", (0.40, 0.38, 0.36), 1)
CONCRETE = Surface("concrete", (0.68, 0.67, 0.65), 0.95)
ASPHALT = Surface("asphalt", (0.30, 0.30, 0.32), 0.95)
MARKING = Surface("marking", (0.93, 0.93, 0.90), 0.9)
RUBBER = Surface("rubber", (0.10, 0.10, 0.11), 0.9)
PLASTER = Surface("plaster", (0.91, 0.89, 0.85), 0.95)
ROOF = Surface("roof tiles", (0.62, 0.30, 0.23), 0.9)
PORCELAIN = Surface("porcelain", (0.97, 0.97, 0.96), 0.1)
FIRE = Surface("fire", (1.0, 0.62, 0.18), 0.9, 0, 0.9)
SKIN = Surface("skin", (0.88, 0.69, 0.56), 0.8)
