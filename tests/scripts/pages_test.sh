#!/usr/bin/env bash
# README is a door: short, and every page of docs/ is linked from it. Every relative link of every
# page leads to a file, and no page holds a @PLACE@ that is still to be filled in. First on a small
# tree where each is wrong, then on the project.
# Status: 0 so it is, 1 not, with a line for each find.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
most=130

# links FILE: the targets of its relative links, a line each, without their #section.
links() {
  grep -oE '\]\([^)#[:space:]]+' "$1" | sed 's/^](//' | grep -vE '^[a-z]+:' || true
}

finds() {
  cd "$1"
  local page target lines
  lines=$(wc -l < README.md)
  ((lines <= most)) || echo "README.md: $lines lines, at most $most"
  for page in README.md docs/*.md; do
    while read -r target; do
      [[ -e $(dirname "$page")/$target ]] || echo "$page: no $target"
    done < <(links "$page")
    { grep -noE '@[A-Z_]+@' "$page" || true; } | sed "s|^|$page:|"
  done
  LC_ALL=C comm -13 <(links README.md | LC_ALL=C sort -u) <(printf '%s\n' docs/*.md | LC_ALL=C sort) |
    sed 's/^/README.md: does not link /'
}

mkdir -p "$folder/docs"
{
  echo '[one](docs/one.md), [gone](docs/gone.md), ![picture](x.png), [far](https://example.org/x)'
  seq "$most"
} > "$folder/README.md"
echo 'from [here](../README.md#part) to [two](two.md) and [none](README.md)' > "$folder/docs/one.md"
echo '@TIMES@' > "$folder/docs/two.md"
diff - <(finds "$folder") << END
README.md: $((most + 1)) lines, at most $most
README.md: no docs/gone.md
README.md: no x.png
docs/one.md: no README.md
docs/two.md:1:@TIMES@
README.md: does not link docs/two.md
END

found=$(finds "$root")
[[ ! $found ]] || { echo "$found" && exit 1; }
echo "links lead somewhere, README is short"
