#!/usr/bin/env bash
# reference_test.sh PROGRAM: the pages that scripts/reference writes are what it writes from PROGRAM.
# First on pages where a line differs. Status: 0 so it is, 1 not, with the lines that differ.
source "$(dirname "${BASH_SOURCE[0]}")/../../support/head.sh"
"$root/scripts/reference" --to "$folder" "$(realpath "$1")"

# finds FOLDER: the lines of its pages that differ.
finds() {
  local page
  find "$folder" -name '*.md' | LC_ALL=C sort | while read -r page; do
    diff "$1/${page#"$folder/"}" "$page" || true
  done
}

cp -r "$root/docs" "$folder.docs"
trap 'rm -rf "$folder" "$folder.docs"' EXIT
sed -i 's/seed/seeed/' "$folder.docs/reference/commands.md"
[[ $(finds "$folder.docs") == *seeed* ]] || fails "a line that differs is found"

found=$(finds "$root/docs")
[[ ! $found ]] || { echo "$found" && echo "scripts/reference writes these pages anew" && exit 1; }
echo "the command reference is current"
