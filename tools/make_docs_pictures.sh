#!/bin/bash
# Draws the pictures in docs/images anew with the program itself: tools/make_docs_pictures.sh. The same program draws the
# same bytes, so a difference in git shows what a change does to pictures.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

images=docs/images
solitaire=${SOLITAIRE:-bin/solitaire}   # another build can be named
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# draw NAME EXAMPLE [OPTION]...: one solution of the example as docs/images/NAME.png.
draw() {
  "$solitaire" generate "examples/$2.sol" -n 1 --png-size 960x640 --quiet -o "$work/$1" "${@:3}"
  cp "$work/$1/$2-0001.png" "$images/$1.png"
}

# draw_sheet NAME EXAMPLE [OPTION]...: nine solutions side by side.
draw_sheet() {
  "$solitaire" generate "examples/$2.sol" -n 9 --png-size 480x360 --quiet -o "$work/$1" "${@:3}"
  cp "$work/$1/sheet.png" "$images/$1.png"
}

# draw_eye NAME...: one solution of each example, at eye height, as docs/images/eye_NAME.png.
draw_eye() {
  for example; do
    "$solitaire" generate "examples/$example.sol" -n 1 --camera eye --png-size 640x400 --quiet -o "$work/eye_$example"
    cp "$work/eye_$example/$example-0001-eye.png" "$images/eye_$example.png"
  done
}

# draw_recipe NAME [OPTION]...: the program of docs/cookbook.md that is fenced as NAME.sol.
draw_recipe() {
  awk -v fence="\`\`\`sol file=$1.sol" '$0 == fence { on = 1; next } /^```/ { on = 0 } on' docs/cookbook.md >"$work/$1.sol"
  "$solitaire" generate "$work/$1.sol" -n 1 --png-size 640x400 --quiet -o "$work/$1" "${@:2}"
  cp "$work/$1/$1-0001.png" "$images/$1.png"
}

draw_sheet workspaces workspace
draw workspace workspace --seed 1
draw workspace_open workspace_open
draw office office
draw classroom classroom
draw flat flat
draw_sheet spaceships spaceship
draw spaceship spaceship --seed 3
draw_eye classroom restaurant city workspace

# The models, a sheet for each set.
"$solitaire" assets --png --png-size 240x180 --quiet -o "$work/models" >/dev/null
cp "$work"/models/models-*.png "$images/"
for recipe in cave river roads rooms level tower parking; do draw_recipe "$recipe"; done
for example in restaurant kitchen shop dungeon parking platforms island garden city seating roof bricks; do
  "$solitaire" generate "examples/$example.sol" -n 1 --png-size 640x400 --quiet -o "$work/$example"
  cp "$work/$example/$example-0001.png" "$images/example_$example.png"
done

# draw_tiles EXAMPLE [OPTION]...: the first map of an example of examples/tiles, as docs/images/tiles-EXAMPLE.png.
draw_tiles() {
  "$solitaire" tiles "examples/tiles/$1.tiles.json" --format png --quiet -o "$work/tiles-$1" "${@:2}"
  cp "$work/tiles-$1/$1-0001.png" "$images/tiles-$1.png"
}

for example in suburb urban pipes platforms railway; do draw_tiles "$example"; done
draw_tiles dungeon -W 40 -H 30
draw_tiles town --seed 2
draw_tiles facade -W 40 -H 20 --seed 1
draw_tiles frame --weights step

# draw_tiles_scene EXAMPLE [OPTION]...: the scene of such a map.
draw_tiles_scene() {
  "$solitaire" tiles "examples/tiles/$1.tiles.json" --format glb --quiet -o "$work/tiles-$1" "${@:2}"
  echo "place(\"tiles-$1/$1-0001.glb\", at: [0, 0, 0]);" >"$work/scene.sol"
  "$solitaire" generate "$work/scene.sol" -n 1 --png-size 960x640 --quiet -o "$work/scene"
  cp "$work/scene/scene-0001.png" "$images/tiles-$1.png"
}

draw_tiles_scene houses --anneal 6 --sweeps 4
