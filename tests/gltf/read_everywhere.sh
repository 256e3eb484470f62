#!/bin/bash
# read_everywhere.sh SOLITAIRE: has Blender and f3d read the scene of each example and of a map of tiles, without a display.
# Ends with status 1 if one of them finds something else than the file has, or shows nothing.
set -euo pipefail
solitaire=$(readlink -f "$1")
cd "$(dirname "$(readlink -f "$0")")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

for example in examples/*.sol; do
  "$solitaire" generate "$example" -n 1 --quiet -o "$work/$(basename "$example" .sol)"
done
for nodes in each chunks; do  # Blender 3.4 does not know instances
  "$solitaire" tiles examples/tiles/houses.tiles.json --nodes "$nodes" --format glb --quiet -o "$work/houses-$nodes"
done
scenes=("$work"/*/*.glb)
blender --background --python-exit-code 1 --python tests/gltf/read_blender.py -- "${scenes[@]}" >"$work/blender.log" 2>&1 || {
  cat "$work/blender.log"
  failed=1
}
for scene in "${scenes[@]}"; do
  xvfb-run -a f3d --output="$work/picture.png" --resolution=400,300 --camera-index=0 "$scene" >"$work/f3d.log" 2>&1 || true
  # A picture of the background alone takes hardly a kilobyte.
  size=$(stat -c %s "$work/picture.png" 2>/dev/null || echo 0)
  [ "$size" -gt 2500 ] || {
    echo "$(basename "$scene"): f3d shows nothing"
    cat "$work/f3d.log"
    failed=1
  }
  rm -f "$work/picture.png"
done
echo "${#scenes[@]} scenes read by Blender and f3d"
exit $failed
