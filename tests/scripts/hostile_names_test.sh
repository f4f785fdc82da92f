#!/usr/bin/env bash
# hostile_names_test.sh SOURCES
#
# A file whose name holds commands of yosys is written and read by that name, or refused; nothing in it
# is run. SOURCES: the project's folder. Status: 0 so, 1 not, 77 where yosys is not installed.
set -euo pipefail

command -v yosys > /dev/null || { echo "skipped: no yosys" && exit 77; }
sources=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
read -ra shape < <(grep -m1 '^[^#]' "$sources/rtl/shipped.txt")

for name in 'a; exec -- touch pwned; log .v' 'a"; exec -- touch pwned; log ".v' 'a b.v'; do
  "$sources/scripts/netlist" --write "$name" generic "${shape[@]}" > said 2>&1 ||
    { cat said && exit 1; }
  grep -q "^module ${shape[0]}\b" "$name" || { echo "$name: no netlist" && exit 1; }
done
[[ ! -e pwned ]] || { echo "the name of a file was run" && exit 1; }
echo "written by their names"
