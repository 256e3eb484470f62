#!/bin/bash
# run.sh SOURCES BUILD CMAKE: installs what is built into a clean folder, moves it, builds a program against it in
# another clean folder, and runs both that program and the moved one. Nothing of it may need the sources or the build.
set -euo pipefail
sources=$1 build=$2 cmake=$3

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "FAILED: $*"
  exit 1
}
# clean COMMAND...: runs it in the root folder and without the environment.
clean() { (cd / && env -i PATH=/usr/bin:/bin "$@"); }

"$cmake" --install "$build" --prefix "$work/installed" >"$work/install.log"
moved=$work/somewhere/else
mkdir "$work/somewhere"
mv "$work/installed" "$moved"

# The program of docs/library.md is its first block of C++. The quotes hold fences of Markdown, and nothing to expand.
# shellcheck disable=SC2016
sed -n '/^```cpp$/,/^```$/{/^```/!p;/^```$/q}' "$sources/docs/library.md" >"$work/documented.cpp"
"$cmake" -S "$sources/tests/install" -B "$work/build" -DCMAKE_PREFIX_PATH="$moved" \
  -DDOCUMENTED_PROGRAM="$work/documented.cpp" ${CXX:+-DCMAKE_CXX_COMPILER="$CXX"} ${CXXFLAGS:+-DCMAKE_CXX_FLAGS="$CXXFLAGS"} >"$work/configure.log"
"$cmake" --build "$work/build"

expected='{"index":1,"value":9,"choices":[{"at":"x","value":9}]}
cancelled
sampled
by Z3'
said=$(clean "$work/build/consumer" "$work/scene.glb")
[ "$said" = "$expected" ] || fail "the consumer said: $said"
[ "$(head -c 4 "$work/scene.glb")" = glTF ] || fail "no scene"

cp "$sources/examples/workspace.sol" "$work/workspace.sol"
clean "$work/build/documented" "$work/workspace.sol" "$work/documented.glb"
[ "$(head -c 4 "$work/documented.glb")" = glTF ] || fail "the program of docs/library.md wrote no scene"

clean "$moved/bin/solitaire" generate "$work/workspace.sol" -n 2 -q -o "$work/out"
[ -s "$work/out/workspace-0002.glb" ] || fail "the moved program wrote no scene"

# Without its data the program says so, and looks neither at the sources nor at the build.
mv "$moved/share" "$moved/shared"
if clean "$moved/bin/solitaire" solve "$work/workspace.sol" -q 2>"$work/said"; then fail "there is other data"; fi
grep -q "share/solitaire is found neither here nor in a folder above" "$work/said" || fail "$(cat "$work/said")"
SOLITAIRE_DATA=$moved/shared/solitaire "$moved/bin/solitaire" solve "$work/workspace.sol" -q >"$work/solution"
