#!/usr/bin/env bash
# Installs the build given as the first argument into new folders and builds projects against it:
# all components, and the core alone.
set -euo pipefail
build=$1
source=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --component core --prefix "$work/core" >/dev/null
cmake -S "$source" -B "$work/core-build" -DCMAKE_PREFIX_PATH="$work/core" -DCMAKE_BUILD_TYPE=Release -DFAIRWAY_CORE_ONLY=ON >/dev/null
cmake --build "$work/core-build" >/dev/null
"$work/core-build/consumer"

cmake --install "$build" --prefix "$work/install" >/dev/null
headers=$(find "$work/install/include" -name '*.hpp' | wc -l)
[ "$headers" -le 40 ] || { echo "expected at most 40 installed headers, found $headers" >&2; exit 1; }
[ -n "$(find "$work/install" -name LICENSE)" ] || { echo "expected an installed LICENSE" >&2; exit 1; }
scenarios=$(find "$work/install" -type d -name scenarios | head -n 1)
if [ ! -e "$work/install/include/fairway/io/maps/map_file.hpp" ]; then
  echo "fairway::io is not built here: only the core was tested"
  exit 0
fi
cmake -S "$source" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/install" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$work/build" >/dev/null
printf 'robot: {radius: 0.25}\n' >"$work/settings.yaml"
"$work/build/consumer_io" "$scenarios/maps/workshop.yaml" "$work/settings.yaml"
