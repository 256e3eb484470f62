#!/usr/bin/env python3
"""scenes.py SOLITAIRE [OPTION]...: how long scenes of 1,000, 10,000 and 100,000 placed chairs take, from the program to all files of
the run, with how much memory; and how many pictures of a workspace are drawn in a second. Options are those of `generate`."""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

FIELD = """
for j in 0..{deep}: for i in 0..{wide}: place("chair", at: [i, j, 0], turn: i % 4);
place("table", at: [range(0, 3), -3, 0]);
"""
WORKSPACE = pathlib.Path(__file__).resolve().parent.parent / "examples/workspace.sol"
PICTURES = 12


def run(command):
    """Returns the seconds that a command took and the most megabytes that it had."""
    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{command} failed")
    return time.monotonic() - start, usage.ru_maxrss * 1024 / 1e6


def measure_scenes(program, folder, options):
    print("objects  seconds  peak MB  .glb MB")
    for wide, deep in [(40, 25), (100, 100), (400, 250)]:
        script = folder / "field.sol"
        script.write_text(FIELD.format(wide=wide - 1, deep=deep - 1))
        output = folder / f"out{wide}"
        seconds, memory = run([program, "generate", script, "-n", "1", "--quiet", "-o", output, *options])
        size = (output / "field-0001.glb").stat().st_size / 1e6
        print(f"{wide * deep:7} {seconds:8.2f} {memory:8.0f} {size:8.1f}")


def measure_pictures(program, folder):
    command = [program, "generate", WORKSPACE, "-n", str(PICTURES), "--quiet", "--jobs", "1", "-o"]
    without, _ = run([*command, folder / "plain"])
    with_pictures, _ = run([*command, folder / "pictures", "--png"])
    print(f"{PICTURES / (with_pictures - without):.1f} pictures a second of 640x480 by one thread")


with tempfile.TemporaryDirectory() as name:
    measure_scenes(sys.argv[1], pathlib.Path(name), sys.argv[2:])
    measure_pictures(sys.argv[1], pathlib.Path(name))
