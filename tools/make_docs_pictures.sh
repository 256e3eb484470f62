#!/bin/bash
# Draws the pictures in docs/images anew with the program itself: tools/make_docs_pictures.sh. The same program draws the
# same bytes, so a difference in git shows what a change does to pictures.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

images=docs/images
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# draw NAME EXAMPLE [OPTION]...: one solution of the example as docs/images/NAME.png.
draw() {
  bin/solitaire generate "examples/$2.sol" -n 1 --png-size 960x640 --quiet -o "$work/$1" "${@:3}"
  cp "$work/$1/$2-0001.png" "$images/$1.png"
}

# draw_sheet NAME EXAMPLE [OPTION]...: nine solutions side by side.
draw_sheet() {
  bin/solitaire generate "examples/$2.sol" -n 9 --png-size 480x360 --quiet -o "$work/$1" "${@:3}"
  cp "$work/$1/sheet.png" "$images/$1.png"
}

draw workspace workspace
draw_sheet workspaces workspace
draw workspace_open workspace_open
draw office office
draw_sheet offices office
