#!/usr/bin/env python3
"""Prints what the tile engine promises beside what is measured: the points of docs/tiles.md, "What is promised".

acceptance.py PROGRAM FIGURES [POINT]...

PROGRAM is the solitaire program, FIGURES solitaire_tiles_paper of the same build. Each line says the point, what is asked
and measured, and whether it is met; the exit status is 1 if something is not. Points are 1 to 10; all of them take some
minutes.
"""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SUBURB = str(ROOT / "examples/tiles/suburb.tiles.json")
MEGABYTE = 1024 * 1024

# The parts of FIGURES that belong to each point.
PARTS = {1: ["exact"], 2: ["never-broken"], 3: ["marginals"], 4: ["figure", "table"], 5: ["speed", "large", "refill"], 10: ["peers"]}


class Measured:
    """A command that has run: its seconds, the most memory that it took in megabytes, and what it printed."""

    def __init__(self, arguments):
        begin = time.monotonic()
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            process = subprocess.Popen(arguments, stdout=out, stderr=err)
            _, status, usage = os.wait4(process.pid, 0)
            self.status = os.waitstatus_to_exitcode(status)
            out.seek(0)
            err.seek(0)
            self.out, self.err = out.read().decode(), err.read().decode()
        self.wall = time.monotonic() - begin
        self.seconds = usage.ru_utime + usage.ru_stime
        self.megabytes = usage.ru_maxrss / 1024


class Acceptance:
    def __init__(self, program, figures):
        self.program, self.figures = program, figures
        self.unmet = 0
        self.folder = Path(tempfile.mkdtemp(prefix="solitaire-acceptance-"))

    def row(self, point, text, met):
        self.unmet += 0 if met else 1
        print(f"{point:>2}  {'met   ' if met else 'NOT MET'} {text}", flush=True)

    def note(self, point, text):
        print(f"{point:>2}         {text}", flush=True)

    def tiles(self, *arguments):
        return Measured([self.program, "tiles", *map(str, arguments)])

    def parts(self, point):
        """Runs parts of FIGURES, whose lines say whether what they ask is met."""
        for part in PARTS.get(point, []):
            run = Measured([self.figures, part])
            title = part
            for line in run.out.splitlines():
                text = line.strip()
                if line and not line.startswith(" "):
                    title = text
                elif text.startswith("pass: ") or text.startswith("FAIL: "):
                    self.row(point, f"{title.split(':')[0]}: {text[6:]}", text.startswith("pass"))
                elif text.startswith("ours: "):
                    self.note(point, text[6:].strip())

    # What is seen of the program from outside.

    def two_jobs(self):
        """Point 5: two maps at a time."""
        weights = self.folder / "suburb.weights.json"
        self.tiles(SUBURB, "--learn", weights, "-n", 0, "-q")
        problem = json.loads(Path(SUBURB).read_text(encoding="utf-8"))
        for name in ("suburb.txt", "suburb.png"):
            shutil.copy(ROOT / "examples/tiles" / name, self.folder)
        problem.update({"weights": weights.name})
        file = self.folder / "learned.tiles.json"
        file.write_text(json.dumps(problem), encoding="utf-8")
        run = lambda jobs: self.tiles(file, "-W", 500, "-H", 500, "-n", 2, "--jobs", jobs, "--sweeps", 8, "--anneal", 8,
                                      "--format", "txt", "-q", "-o", self.folder / f"jobs{jobs}").wall
        faster = run(1) / run(2)
        self.row(5, f"two maps of 500x500 by --jobs 2: {faster:.2f} times as fast, at least 1.7 asked", faster >= 1.7)

    def memory(self):
        plain = ["--weights", "step", "--anneal", 0, "--sweeps", 0, "-q"]
        small = self.tiles(SUBURB, "-W", 170, "-H", 170, "--format", "txt", "-q", "-o", self.folder / "m")
        self.row(6, f"170x170 with fitted weights: {small.megabytes:.0f} MB, at most 60 asked", small.megabytes <= 60)
        self.tiles(SUBURB, "-W", 1000, "-H", 1000, *plain, "--format", "glb", "--nodes", "plain", "-o", self.folder / "large")
        size = (self.folder / "large/suburb-0001.glb").stat().st_size / MEGABYTE
        self.row(6, f".glb of 1000x1000 as instances: {size:.0f} MB, at most 40 asked", size <= 40)

    def digest(self, folder):
        found = hashlib.sha256()
        for file in sorted(folder.glob("*.txt")) + sorted(folder.glob("*.png")):
            found.update(file.name.encode() + file.read_bytes())
        return found.hexdigest()

    def same_bytes(self):
        def digest(name, *arguments):
            folder = self.folder / name
            self.tiles(SUBURB, "-W", 60, "-H", 50, "--seed", 5, "-q", "-o", folder, *arguments)
            return self.digest(folder)

        first = digest("one", "-n", 4)
        self.row(7, "--jobs 1 and --jobs 3 write the same bytes", first == digest("three", "-n", 4, "--jobs", 3))
        self.row(7, "another run writes the same bytes", first == digest("again", "-n", 4))
        both = ["--chunk=0,0", "--chunk=1,-2"]
        self.tiles(SUBURB, "-W", 30, "-H", 30, "-q", "-o", self.folder / "both", *both)
        self.tiles(SUBURB, "-W", 30, "-H", 30, "-q", "-o", self.folder / "alone", both[1])
        name = "suburb_1_-2.txt"
        same = (self.folder / "both" / name).read_bytes() == (self.folder / "alone" / name).read_bytes()
        self.row(7, "a chunk made alone is the chunk made with others", same)

    def tiled_map(self):
        """Writes a map of Tiled that has all eight orientations of its tiles, and its tileset."""
        picture = str(self.folder / "suburb.png")
        shutil.copy(ROOT / "examples/tiles/suburb.png", picture)
        data = ",".join(str((1 + x + y * 5) % 16 + 1 + (((x + y) % 8) << 29)) for y in range(12) for x in range(16))
        (self.folder / "turned.tmx").write_text(
            '<map version="1.8" orientation="orthogonal" renderorder="right-down" width="16" height="12" tilewidth="16" '
            'tileheight="16"><tileset firstgid="1" name="s" tilewidth="16" tileheight="16" tilecount="16" columns="8">'
            f'<image source="suburb.png" width="128" height="32"/></tileset><layer id="1" name="l" width="16" height="12">'
            f'<data encoding="csv">{data}</data></layer></map>', encoding="utf-8")
        return self.folder / "turned.tmx"

    def files(self):
        exemplar = self.tiled_map()
        out = self.folder / "tmx"
        run = self.tiles(exemplar, "-W", 40, "-H", 30, "--weights", "step", "--format", "tmx,png", "-q", "-o", out)
        checked = self.tiles(exemplar, "-W", 40, "-H", 30, "--check", out / "turned-0001.tmx")
        self.row(8, "a map with all eight orientations is read back from the .tmx that was written",
                 run.status == 0 and checked.status == 0)
        drawer = shutil.which("tmxrasterizer")
        if not drawer:
            self.note(8, "the pictures were not compared: tmxrasterizer is not installed (package tiled)")
            return
        drawn = out / "drawn.png"
        subprocess.run([drawer, out / "turned-0001.tmx", drawn], check=True, capture_output=True,
                       env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
        from PIL import Image  # of python3-pil

        ours, theirs = (Image.open(file).convert("RGBA") for file in (out / "turned-0001.png", drawn))
        self.row(8, "Tiled's tmxrasterizer draws the same picture", ours.tobytes() == theirs.tobytes())

    def language(self):
        def script(name, width, height, more=""):
            file = self.folder / name
            file.write_text(f'import "std/tiles.sol";\nset = tiles("{ROOT}/examples/tiles/suburb.txt");\n'
                            f"map = tile_map(set, {width}, {height});\n{more}return map;\n", encoding="utf-8")
            return file

        large = Measured([self.program, "solve", str(script("large.sol", 85, 85)), "-n", "1", "-q"])
        self.row(9, f"85x85 by the exact engine: {large.seconds:.1f} s, at most 1.5 asked", large.seconds <= 1.5)
        self.row(9, f"and {large.megabytes:.0f} MB, at most 250 asked", large.megabytes <= 250)
        small = script("small.sol", 2, 2)
        count = Measured([self.program, "count", str(small), "--exact", "-q"]).out.split()
        listed = [len(set(Measured([self.program, "solve", str(small), "--all", "--json", "-q", "--engine", engine]).out.splitlines()))
                  for engine in ("cadical", "z3")]
        numbers = [int(word) for word in count if word.isdigit()][:1] + listed
        self.row(9, f"maps of 2x2 that are counted, and listed with CaDiCaL and Z3: {numbers}", len(set(numbers)) == 1)

    def run(self, points):
        outside = {5: [self.two_jobs], 6: [self.memory], 7: [self.same_bytes], 8: [self.files], 9: [self.language]}
        for point in points:
            self.parts(point)
            for check in outside.get(point, []):
                check()
        shutil.rmtree(self.folder)
        return self.unmet


def main():
    if len(sys.argv) < 3 or not all(re.fullmatch(r"[1-9]|10", word) for word in sys.argv[3:]):
        sys.exit(__doc__)
    points = [int(word) for word in sys.argv[3:]] or list(range(1, 11))
    sys.exit(1 if Acceptance(sys.argv[1], sys.argv[2]).run(points) else 0)


main()
