#!/usr/bin/env python3
"""Draws docs/images/sampling_*.svg anew: how often values of the examples' numbers occur in their draws.

    tools/make_sampling_pictures.py build/app/solitaire

The curves are those of the page that `solitaire sample --report` writes, one for each chain.
"""
import html
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
MODELS = {
    "ising": ["--set", "coupling=1.0"],
    "regression": [],
    "rats": ["--warmup", "4000"],
    "mixture": [],
    "infinite_mixture": [],
    "lda": [],
    "hdp": [],
    "citations": [],
    "sum_or_product": [],
    "polynomial": [],
}
MOST_NUMBERS = 4
WIDTH, HEIGHT, LINE, GAP = 320, 120, 18, 16
NUMBER = re.compile(
    r'<h2>(?P<name>[^<]*)</h2>\s*<figure><svg [^>]*from (?P<low>\S+) to (?P<high>[^"]+)">.*?'
    r'<svg [^>]*how often[^>]*>(?P<curves>.*?)</svg>',
    re.DOTALL,
)


def numbers_of(program, model, options):
    """Name, least and greatest value, and curves of each number in the report of a run."""
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "report.html"
        script = ROOT / "examples" / "sampling" / f"{model}.sol"
        command = [program, "sample", script, "-n", "8000", "-q", "--report", page, *options]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return [each.groupdict() for each in NUMBER.finditer(page.read_text())]


def panel(number, x):
    """A number's curves below its name, with the least and the greatest value at the ends."""
    text = f'<text x="{{}}" y="{{}}" font-family="sans-serif" font-size="12" fill="#565d67" text-anchor="{{}}">{{}}</text>'
    name = html.escape(html.unescape(number["name"]))
    return "".join(
        [
            f'<g transform="translate({x},0)">',
            text.format(0, LINE - 5, "start", name),
            f'<g transform="translate(0,{LINE})"><rect width="{WIDTH}" height="{HEIGHT}" fill="#f6f6f4"/>',
            number["curves"],
            "</g>",
            text.format(0, LINE + HEIGHT + LINE - 4, "start", number["low"]),
            text.format(WIDTH, LINE + HEIGHT + LINE - 4, "end", number["high"]),
            "</g>\n",
        ]
    )


def picture(numbers):
    width = len(numbers) * (WIDTH + GAP) - GAP
    height = HEIGHT + 2 * LINE
    panels = "".join(panel(number, i * (WIDTH + GAP)) for i, number in enumerate(numbers))
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}">\n{panels}</svg>\n'


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    for model, options in MODELS.items():
        numbers = numbers_of(program, model, options)[:MOST_NUMBERS]
        (ROOT / "docs" / "images" / f"sampling_{model}.svg").write_text(picture(numbers))


if __name__ == "__main__":
    main()
