#!/usr/bin/env python3
"""Draws the icons of examples/tiles: facade, frame, platforms, pipes, railway. Run it from anywhere; it writes NAME.png there.

A sheet has eight icons of 16x16 pixels in a row, in the order in which NAME.tiles.json lists the tiles.
"""

import math
import pathlib
import struct
import zlib

SIDE = 16
FOLDER = pathlib.Path(__file__).resolve().parent.parent / "examples" / "tiles"


class Icon:
    """A square of pixels."""

    def __init__(self, color):
        self.pixels = [[color] * SIDE for _ in range(SIDE)]

    def dot(self, x, y, color):
        if 0 <= x < SIDE and 0 <= y < SIDE:
            self.pixels[y][x] = color
        return self

    def box(self, x0, y0, x1, y1, color):
        """Fills from (x0, y0) to (x1, y1), both included."""
        for y in range(y0, y1 + 1):
            for x in range(x0, x1 + 1):
                self.dot(x, y, color)
        return self

    def disc(self, cx, cy, radius, color):
        for y in range(SIDE):
            for x in range(SIDE):
                if (x + 0.5 - cx) ** 2 + (y + 0.5 - cy) ** 2 <= radius * radius:
                    self.dot(x, y, color)
        return self

    def flipped(self, across=False, down=False, diagonal=False):
        result = Icon(None)
        for y in range(SIDE):
            for x in range(SIDE):
                fx, fy = (SIDE - 1 - x if across else x), (SIDE - 1 - y if down else y)
                if diagonal:
                    fx, fy = fy, fx
                result.pixels[y][x] = self.pixels[fy][fx]
        return result

    def over(self, other):
        """Puts the pixels of another icon that have a colour on this one."""
        for y in range(SIDE):
            for x in range(SIDE):
                if other.pixels[y][x] is not None:
                    self.pixels[y][x] = other.pixels[y][x]
        return self


def shade(color, factor):
    return tuple(max(0, min(255, round(channel * factor))) for channel in color)


def write_sheet(name, icons):
    rows = (len(icons) + 7) // 8
    lines = []
    for row in range(rows):
        for y in range(SIDE):
            line = b"\0"
            for column in range(8):
                number = 8 * row + column
                for x in range(SIDE):
                    line += bytes((*icons[number].pixels[y][x], 255)) if number < len(icons) else bytes(4)
            lines.append(line)

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    header = struct.pack(">IIBBBBB", 8 * SIDE, rows * SIDE, 8, 6, 0, 0, 0)
    data = zlib.compress(b"".join(lines), 9)
    (FOLDER / (name + ".png")).write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")
    )


# ---- a facade of brick and sandstone

SKY, BRICK, MORTAR = (164, 204, 230), (166, 86, 64), (186, 112, 88)
STONE, GLASS, IRON = (222, 206, 172), (62, 84, 108), (44, 46, 52)


def bricks():
    icon = Icon(BRICK)
    for y in range(SIDE):
        for x in range(SIDE):
            if y % 4 == 3 or (x + (4 if y // 4 % 2 else 0)) % 8 == 7:
                icon.dot(x, y, MORTAR)
            elif (x * 7 + y // 4 * 5) % 11 == 3:
                icon.dot(x, y, shade(BRICK, 0.93))
    return icon


def band(icon, top, bottom, color=STONE):
    """A course of stone, lit from above."""
    icon.box(0, top, 15, bottom, color)
    icon.box(0, top, 15, top, shade(color, 1.12))
    icon.box(0, bottom, 15, bottom, shade(color, 0.72))
    return icon


def glass(icon, x0, y0, x1, y1):
    icon.box(x0, y0, x1, y1, GLASS)
    for y in range(y0, y1 + 1):
        for x in range(x0, x1 + 1):
            if (x + 2 * y) % 13 < 3:
                icon.dot(x, y, shade(GLASS, 1.35))
    return icon


def window_top():
    icon = bricks()
    icon.box(2, 3, 13, 15, STONE).box(2, 3, 13, 3, shade(STONE, 1.12))
    icon.box(7, 2, 8, 5, shade(STONE, 1.12))
    glass(icon, 4, 6, 11, 15)
    icon.box(4, 6, 11, 6, shade(GLASS, 0.6)).box(7, 6, 8, 15, (236, 232, 222)).box(4, 11, 11, 11, (236, 232, 222))
    return icon


def window_bottom():
    icon = bricks()
    icon.box(2, 0, 13, 10, STONE)
    glass(icon, 4, 0, 11, 9)
    icon.box(7, 0, 8, 9, (236, 232, 222)).box(4, 4, 11, 4, (236, 232, 222))
    icon.box(1, 10, 14, 11, shade(STONE, 1.08)).box(1, 12, 14, 12, shade(STONE, 0.65))
    return icon


def balcony():
    icon = bricks()
    icon.box(2, 0, 13, 12, STONE)
    glass(icon, 4, 0, 11, 12)
    icon.box(7, 0, 8, 12, (236, 232, 222))
    icon.box(0, 6, 15, 6, IRON).box(0, 12, 15, 12, IRON)
    for x in range(0, 16, 2):
        icon.box(x, 6, x, 12, IRON)
    return icon.box(0, 13, 15, 14, shade(STONE, 1.05)).box(0, 15, 15, 15, shade(STONE, 0.6))


def quoins(icon):
    """The left edge of a house: blocks of stone, one long, one short."""
    icon.box(0, 0, 1, 15, SKY)
    for y, wide in ((0, 8), (4, 5), (8, 8), (12, 5)):
        icon.box(2, y, 1 + wide, y + 3, STONE).box(2, y + 3, 1 + wide, y + 3, shade(STONE, 0.75))
        icon.box(2, y, 1 + wide, y, shade(STONE, 1.1))
    return icon


def parapet():
    icon, wall = Icon(SKY), bricks()
    for y in range(7, 16):
        icon.pixels[y] = list(wall.pixels[y])
    for x in (1, 9):
        icon.box(x, 3, x + 4, 8, STONE).box(x, 3, x + 4, 3, shade(STONE, 1.12)).box(x + 4, 4, x + 4, 8, shade(STONE, 0.8))
    return band(icon, 8, 10)


def parapet_corner():
    icon = parapet()
    icon.box(0, 0, 1, 15, SKY).box(0, 0, 15, 6, SKY)
    icon.box(2, 2, 8, 15, STONE).box(2, 2, 8, 2, shade(STONE, 1.12)).box(1, 4, 9, 5, shade(STONE, 1.08))
    icon.box(8, 6, 8, 15, shade(STONE, 0.8))
    return icon.disc(5, 1.5, 1.6, shade(STONE, 1.05))


def cornice():
    icon = bricks()
    band(icon, 0, 3)
    band(icon, 4, 8, shade(STONE, 0.94))
    for x in range(1, 16, 4):
        icon.box(x, 9, x + 1, 11, STONE).box(x, 11, x + 1, 11, shade(STONE, 0.7))
    return icon


def cornice_end():
    icon = cornice()
    icon.box(0, 0, 0, 15, SKY).box(0, 9, 1, 15, SKY).box(1, 0, 1, 8, shade(STONE, 1.1))
    return icon


def frieze():
    icon = band(bricks(), 1, 14, (198, 150, 112))
    for cx in (4, 12):
        for d in range(4):
            icon.box(cx - 4 + d, 7 - d, cx + 3 - d, 8 + d, shade((198, 150, 112), 0.86 - 0.06 * d) if d < 3 else (112, 52, 44))
    return icon


def belt():
    icon = band(band(bricks(), 0, 2), 12, 15)
    icon.box(0, 3, 15, 11, (34, 66, 58)).box(0, 4, 15, 4, (52, 90, 78))
    for x in range(1, 16, 5):
        icon.box(x, 6, x + 2, 8, (214, 178, 92))
    return icon


def shop_top():
    icon = Icon(shade(STONE, 0.95))
    icon.box(0, 0, 0, 15, shade(STONE, 0.75)).disc(8, 11, 6.6, shade(STONE, 0.7)).disc(8, 11, 6, GLASS)
    glass(icon, 2, 11, 13, 15)
    return icon.box(7, 5, 8, 15, IRON).box(2, 11, 13, 11, IRON)


def shop_bottom():
    icon = Icon(shade(STONE, 0.95))
    icon.box(0, 0, 0, 15, shade(STONE, 0.75))
    glass(icon, 2, 0, 13, 9)
    icon.box(7, 0, 8, 9, IRON).box(1, 10, 14, 10, shade(STONE, 1.1))
    return icon.box(0, 13, 15, 15, shade(STONE, 0.62))


def door(top):
    icon = Icon(shade(STONE, 0.95))
    wood = (92, 58, 40)
    icon.box(0, 0, 0, 15, shade(STONE, 0.75))
    if top:
        icon.disc(8, 10, 7, shade(STONE, 0.7)).disc(8, 10, 6, (220, 190, 120)).box(2, 10, 13, 15, wood)
        for x in (5, 8, 11):
            icon.box(x, 4, x, 9, shade(wood, 0.8))
        icon.box(2, 9, 13, 10, shade(wood, 0.7))
    else:
        icon.box(2, 0, 13, 13, wood).box(1, 14, 14, 15, shade(STONE, 0.8))
        icon.box(6, 5, 6, 6, (220, 190, 100)).box(9, 5, 9, 6, (220, 190, 100))
    for x0, x1 in ((3, 6), (9, 12)):
        y0, y1 = (12, 15) if top else (0, 3)
        icon.box(x0, y0, x1, y1, shade(wood, 1.2))
    return icon.box(7, 11 if top else 0, 8, 15 if top else 13, shade(wood, 0.6))


def pavement():
    icon = Icon((132, 130, 126)).box(0, 0, 15, 2, (176, 172, 164)).box(0, 3, 15, 3, (96, 94, 92))
    for x in (3, 11):
        icon.box(x, 0, x, 2, (148, 144, 138))
    return icon.box(0, 15, 15, 15, (112, 110, 108))


def facade():
    wall = quoins(bricks())
    return [Icon(SKY), parapet_corner(), parapet(), parapet_corner().flipped(across=True), cornice_end(), cornice(),
            cornice_end().flipped(across=True), wall, wall.flipped(across=True), frieze(), window_top(),
            window_bottom(), balcony(), bricks(), band(bricks(), 5, 11), belt(), shop_top(), shop_bottom(), door(True),
            door(False), pavement()]


# ---- a gilded picture frame

GOLD, WALL, TAPESTRY = (206, 162, 74), (92, 108, 98), (38, 66, 62)


def moulding():
    """The upper side of the outer moulding: a hollow between two edges."""
    icon = Icon(WALL)
    for y in range(4, 16):
        icon.box(0, y, 15, y, shade(GOLD, (1.25, 1.15, 1.0, 0.85, 0.7, 0.62, 0.66, 0.78, 0.92, 1.05, 1.2, 0.8)[y - 4]))
    return icon


def outer_corner():
    icon, side = moulding(), moulding().flipped(diagonal=True)
    for y in range(SIDE):
        for x in range(SIDE):
            if y > x:
                icon.pixels[y][x] = shade(side.pixels[y][x], 0.97)
    return icon


def ground():
    return Icon(shade(GOLD, 0.72))


def bead():
    return ground().disc(8, 8, 3.2, shade(GOLD, 0.5)).disc(7.6, 7.4, 2.8, GOLD).disc(7, 6.6, 1, (255, 236, 170))


def leaf():
    """A leaf that grows from the right side to the left."""
    icon = ground()
    for x in range(2, 16):
        half = round(5.5 * (1 - ((x - 11) / 10) ** 2)) if x > 1 else 0
        for d in range(-half, half + 1):
            icon.dot(x, 8 + d, shade(GOLD, 1.18 if d < 0 else 0.92))
        icon.dot(x, 8, shade(GOLD, 0.6))
        if x % 3 == 0:
            for d in range(1, half):
                icon.dot(x - d // 2, 8 - d, shade(GOLD, 0.8))
                icon.dot(x - d // 2, 8 + d, shade(GOLD, 0.7))
    return icon


def rosette(radius=6.5):
    icon = ground().disc(8, 8, radius, shade(GOLD, 0.55))
    for cx, cy in ((8, 3.6), (12.2, 6.6), (10.6, 11.6), (5.4, 11.6), (3.8, 6.6)):
        icon.disc(cx, cy, 2.7, GOLD).disc(cx - 0.5, cy - 0.6, 1.3, shade(GOLD, 1.22))
    return icon.disc(8, 8, 2.2, (150, 60, 48)).disc(7.5, 7.4, 0.9, (220, 130, 110))


def tapestry():
    """The woven ground of the picture, with blades of grass."""
    icon = Icon(TAPESTRY)
    for y in range(SIDE):
        for x in range(y % 2, SIDE, 2):
            icon.dot(x, y, shade(TAPESTRY, 0.92))
    for x, y in ((2, 3), (10, 1), (13, 9), (6, 12)):
        icon.box(x, y, x, y + 2, shade(TAPESTRY, 1.35)).dot(x + 1, y - 1, shade(TAPESTRY, 1.35))
    return icon


def sprig(petals, heart):
    """A flower with its stalk and two leaves."""
    green = (104, 148, 84)
    icon = tapestry().box(8, 8, 8, 14, shade(green, 0.8))
    for x, y in ((6, 11), (5, 10), (4, 10), (10, 12), (11, 11), (12, 11)):
        icon.box(x, y, x + 1, y + 1, green)
    for cx, cy in ((8.5, 2.6), (12, 5.2), (10.6, 8.8), (6.4, 8.8), (5, 5.2)):
        icon.disc(cx, cy, 2.3, petals).disc(cx - 0.4, cy - 0.5, 1.0, shade(petals, 1.25))
    return icon.disc(8.5, 6, 1.8, heart)


def bells():
    """Three blue bells at one stalk."""
    green, blue = (104, 148, 84), (116, 142, 206)
    icon = tapestry().box(8, 3, 8, 14, green).box(5, 3, 8, 3, green).box(8, 6, 11, 6, green).box(5, 9, 8, 9, green)
    for x, y in ((4, 4), (10, 7), (4, 10)):
        icon.box(x, y, x + 2, y + 2, blue).box(x, y, x, y + 2, shade(blue, 1.2))
        icon.dot(x - 1, y + 3, shade(blue, 0.85)).dot(x + 1, y + 3, shade(blue, 0.85)).dot(x + 3, y + 3, shade(blue, 0.85))
    return icon


def hare():
    """A hare that sits and looks to the right."""
    fur = (208, 184, 148)
    icon = tapestry().disc(6.5, 10.5, 4.2, shade(fur, 0.75)).disc(6.8, 10.2, 3.8, fur).disc(11, 7, 2.7, fur)
    icon.box(9, 1, 9, 5, fur).box(11, 1, 11, 5, shade(fur, 0.85)).disc(2.8, 12, 1.5, (238, 230, 214))
    icon.box(9, 12, 12, 13, shade(fur, 0.85)).box(4, 14, 9, 14, shade(fur, 0.65))
    return icon.dot(12, 6, (40, 30, 30)).dot(13, 8, (150, 90, 80))


def inner():
    icon = tapestry()
    for y in range(0, 7):
        icon.box(0, y, 15, y, shade(GOLD, (1.2, 1.05, 0.9, 0.8, 1.0, 1.22, 0.55)[y]))
    return icon.box(0, 7, 15, 8, shade(TAPESTRY, 0.7))


def inner_corner():
    icon, side = inner(), inner().flipped(diagonal=True)
    for y in range(SIDE):
        for x in range(SIDE):
            if y > x:
                icon.pixels[y][x] = side.pixels[y][x]
    return icon


def four_corners(icon):
    return [icon, icon.flipped(across=True), icon.flipped(down=True), icon.flipped(across=True, down=True)]


def four_sides(icon):
    left = icon.flipped(diagonal=True)
    return [icon, icon.flipped(down=True), left, left.flipped(across=True)]


def frame():
    up = leaf().flipped(diagonal=True)
    return (four_corners(outer_corner()) + four_sides(moulding()) + [rosette(7.5), bead(), bead()] +
            [leaf(), leaf().flipped(across=True), rosette(), up, up.flipped(down=True), rosette()] +
            four_corners(inner_corner()) + four_sides(inner()) +
            [tapestry(), sprig((206, 84, 84), (240, 206, 110)), sprig((232, 222, 200), (226, 170, 60)),
             sprig((226, 160, 170), (150, 60, 70)), bells(), hare(), hare().flipped(across=True)])


# ---- a level of platforms

AIR, EARTH, GRASS = (122, 184, 228), (136, 94, 62), (98, 168, 72)


def earth():
    icon = Icon(EARTH)
    for x, y, w in ((2, 3, 3), (9, 1, 2), (12, 7, 3), (5, 9, 2), (1, 13, 2), (9, 12, 4)):
        icon.box(x, y, x + w, y + 1, shade(EARTH, 0.8)).box(x, y, x + w, y, shade(EARTH, 1.15))
    return icon


def turf():
    icon = earth().box(0, 0, 15, 4, GRASS).box(0, 0, 15, 1, shade(GRASS, 1.2))
    for x in range(0, 16, 4):
        icon.box(x, 5, x + 1, 6, shade(GRASS, 0.85)).dot(x + 2, 5, shade(GRASS, 0.85))
    return icon


def plank(end):
    icon = Icon(AIR)
    wood = (190, 140, 84)
    icon.box(3 if end else 0, 1, 15, 6, wood).box(3 if end else 0, 1, 15, 1, shade(wood, 1.2))
    icon.box(3 if end else 0, 6, 15, 6, shade(wood, 0.6)).box(7, 2, 7, 5, shade(wood, 0.75)).box(15, 2, 15, 5, shade(wood, 0.75))
    if end:
        icon.box(3, 2, 4, 5, shade(wood, 0.7)).box(6, 7, 8, 9, shade(wood, 0.6)).box(7, 10, 8, 11, shade(wood, 0.55))
    return icon


def ladder():
    icon = Icon(AIR)
    for x in (3, 11):
        icon.box(x, 0, x + 1, 15, (150, 104, 60))
    for y in (2, 7, 12):
        icon.box(3, y, 12, y + 1, (184, 134, 80)).box(3, y + 2, 12, y + 2, (112, 76, 44))
    return icon


def coin():
    return Icon(AIR).disc(8, 8, 4.6, (176, 120, 20)).disc(8, 8, 3.8, (248, 206, 70)).box(7, 6, 8, 10, (214, 160, 40)).dot(6, 5, (255, 244, 190))


def spikes():
    icon = Icon(AIR)
    for x0 in (0, 5, 10):
        for y in range(6, 16):
            half = (y - 6) / 10 * 2.6
            icon.box(round(x0 + 2.7 - half), y, round(x0 + 2.7 + half), y, (176, 182, 190))
            icon.dot(round(x0 + 2.7 - half), y, (224, 228, 234))
    return icon


def bush():
    icon = Icon(AIR)
    for cx, cy, r in ((4, 12, 4), (12, 12, 4), (8, 9.5, 5)):
        icon.disc(cx, cy, r, shade(GRASS, 0.7))
    for cx, cy, r in ((4, 11.5, 2.8), (8, 8.5, 3.6)):
        icon.disc(cx, cy, r, shade(GRASS, 0.88))
    return icon.box(0, 15, 15, 15, shade(GRASS, 0.7))


def cloud(left):
    icon = Icon(AIR)
    white = (240, 246, 250)
    for cx, cy, r in ((8, 9, 4.4), (13, 7, 5.2), (16, 9, 5)):
        icon.disc(cx, cy, r, white)
    icon.box(5, 12, 15, 13, (206, 224, 238))
    return icon if left else icon.flipped(across=True)


def platforms():
    return [Icon(AIR), turf(), earth(), plank(True), plank(False), plank(True).flipped(across=True), ladder(), coin(),
            spikes(), bush(), cloud(True), cloud(False)]


# ---- pipes

STEEL, BACK = (150, 170, 182), (46, 54, 64)


def arm():
    """A pipe from the middle to the right side."""
    icon = Icon(None)
    for y in range(4, 12):
        icon.box(8, y, 15, y, shade(STEEL, (0.62, 0.9, 1.18, 1.3, 1.1, 0.92, 0.75, 0.5)[y - 4]))
    for y in range(3, 13):
        icon.box(13, y, 15, y, shade(STEEL, (0.5, 0.7, 1.0, 1.25, 1.35, 1.15, 0.95, 0.8, 0.62, 0.4)[y - 3]))
    return icon


def pipes():
    background = Icon(BACK)
    for x, y in ((2, 2), (13, 2), (2, 13), (13, 13)):
        background.dot(x, y, shade(BACK, 1.4))
    right = arm()
    arms = [right, right.flipped(across=True), right.flipped(diagonal=True),
            right.flipped(diagonal=True).flipped(down=True)]
    icons = []
    for sides in range(16):
        icon = Icon(BACK).over(background)
        for number, each in enumerate(arms):
            if sides >> number & 1:
                icon.over(each)
        if sides in (1, 2, 4, 8):
            icon.disc(8, 8, 5.4, shade(STEEL, 0.5)).disc(8, 8, 4.6, (178, 62, 48)).disc(7.2, 7, 2, (226, 120, 96))
        elif sides not in (0, 3, 12):
            icon.disc(8, 8, 4.4, shade(STEEL, 0.7)).disc(7.7, 7.6, 3.6, shade(STEEL, 1.1)).disc(7, 6.8, 1.4, shade(STEEL, 1.4))
        icons.append(icon)
    return icons


# ---- a railway on a meadow: one icon for each track; the program turns them

MEADOW, BALLAST, SLEEPER, RAIL = (126, 166, 88), (170, 158, 142), (104, 78, 58), (66, 68, 76)


def meadow():
    icon = Icon(MEADOW)
    for y in range(SIDE):
        for x in range(SIDE):
            if (x * 13 + y * 7 + x * y * 3) % 29 == 4:
                icon.dot(x, y, shade(MEADOW, 0.88))
            elif (x * 5 + y * 11 + x * y) % 31 == 9:
                icon.dot(x, y, shade(MEADOW, 1.1))
    return icon


def straight_parts(first=0, last=15):
    """Yields (pixel, distance along the track, distance across it) of a track from the left to the right."""
    for y in range(SIDE):
        for x in range(first, last + 1):
            yield (x, y), x + 0.5, y - 7.5


def bend_parts(corner_x, corner_y):
    """The same for a quarter of a circle around a corner of the icon."""
    for y in range(SIDE):
        for x in range(SIDE):
            dx, dy = x + 0.5 - corner_x, y + 0.5 - corner_y
            yield (x, y), math.atan2(abs(dy), abs(dx)) * 8, math.hypot(dx, dy) - 8


def down(parts):
    for (x, y), along, across in parts:
        yield (y, x), along, across


def tracks(*courses):
    """Ballast under all, then sleepers, then rails, so that tracks that meet share them."""
    icon = meadow()
    courses = [list(course) for course in courses]
    for limit, wanted, color in ((6, lambda _: True, BALLAST), (4.6, lambda along: along % 4 < 1.7, SLEEPER)):
        for course in courses:
            for (x, y), along, across in course:
                if abs(across) < limit - 0.4 and wanted(along + 1):
                    icon.dot(x, y, color if (x * 7 + y * 5) % 6 else shade(color, 0.93))
    for course in courses:
        for (x, y), _, across in course:
            if 2 <= abs(across) < 3:
                icon.dot(x, y, RAIL if across > 0 else shade(RAIL, 1.5))
    return icon


def buffer_stop():
    icon = tracks(straight_parts(0, 10))
    icon.box(10, 2, 12, 13, (178, 62, 50)).box(10, 2, 12, 2, (224, 120, 100)).box(13, 3, 13, 14, shade(MEADOW, 0.7))
    return icon.box(10, 5, 12, 6, (240, 236, 226)).box(10, 9, 12, 10, (240, 236, 226))


def platform():
    icon = tracks(straight_parts())
    icon.box(0, 0, 15, 2, (206, 200, 190)).box(0, 2, 15, 2, (240, 214, 96)).box(0, 13, 15, 15, (206, 200, 190))
    return icon.box(0, 13, 15, 13, (240, 214, 96)).box(0, 15, 15, 15, (168, 162, 152))


def firs():
    icon = meadow()
    for x, y in ((4, 6), (11, 4), (8, 11)):
        icon.disc(x + 1, y + 1.6, 3.2, shade(MEADOW, 0.72)).disc(x, y, 3.2, (58, 108, 66)).disc(x - 0.6, y - 0.8, 1.6, (92, 146, 88))
    return icon


def railway():
    return [
        meadow(),
        firs(),
        tracks(straight_parts()),
        tracks(bend_parts(16, 16)),
        tracks(straight_parts(), bend_parts(16, 16), bend_parts(0, 16)),
        tracks(straight_parts(), down(straight_parts())),
        buffer_stop(),
        platform(),
    ]


if __name__ == "__main__":
    for draw in (facade, frame, platforms, pipes, railway):
        write_sheet(draw.__name__, draw())
