#!/usr/bin/env bash
# README is a door: short, and every page of docs/ is linked from it. Every relative link of every
# page leads to a file and, behind a #, to a heading of it. Each page of docs/ begins with what one can
# do after reading it, and no page holds a @PLACE@ that is still to be filled in. First on a small tree
# where each is wrong, then on the project. And a script whose table a page has says which row differs.
# Status: 0 so it is, 1 not, with a line for each find.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
most=130

# text FILE: its lines outside of fenced blocks, without `code`.
text() { awk '/^```/ { fenced = !fenced; next } !fenced { gsub(/`[^`]*`/, ""); print }' "$1"; }

# links FILE: the targets of its relative links, a line each.
links() { text "$1" | grep -oE '\]\([^)[:space:]]+' | sed 's/^](//' | grep -vE '^[a-z]+:' || true; }

# anchors FILE: what a #part may say of it, a line for each heading.
anchors() {
  awk '/^```/ { fenced = !fenced } /^#+ / && !fenced { sub(/^#+ /, ""); print }' "$1" |
    tr '[:upper:]' '[:lower:]' | sed 's/[^a-z0-9 _-]//g; s/ /-/g'
}

finds() {
  cd "$1"
  local page target file lines
  lines=$(wc -l < README.md)
  ((lines <= most)) || echo "README.md: $lines lines, at most $most"
  for page in README.md docs/*.md; do
    while read -r target; do
      file=${target%%#*}
      [[ ! $file ]] && file=$page || file=$(dirname "$page")/$file
      if [[ ! -e $file ]]; then
        echo "$page: no $target"
      elif [[ $target == *#* ]] && ! grep -qxF -- "${target#*#}" <(anchors "$file"); then
        echo "$page: no heading for $target"
      fi
    done < <(links "$page")
    { grep -noE '@[A-Z_]+@' "$page" || true; } | sed "s|^|$page:|"
    [[ $page == README.md || $(sed -n 3p "$page") == "After this page you "* ]] ||
      echo "$page:3: does not say what one can do after it"
  done
  LC_ALL=C comm -13 <(links README.md | LC_ALL=C sort -u) <(printf '%s\n' docs/*.md | LC_ALL=C sort) |
    sed 's/^/README.md: does not link /'
}

mkdir -p "$folder/docs"
{
  echo '[one](docs/one.md), [gone](docs/gone.md), ![picture](x.png), [far](https://example.org/x)'
  echo "\`[code](nowhere)\`"
  seq "$((most - 1))"
} > "$folder/README.md"
cat > "$folder/docs/one.md" << 'END'
# One

After this page you know two, [here](#the-rest-of-it-2) and [there](#the-rest), not [none](README.md).

```sh
# [a comment](nowhere)
```

## The rest of `it`: 2
END
printf '# Two\n\n@TIMES@, [one](one.md#one), [code](one.md#a-commentnowhere)\n' > "$folder/docs/two.md"
diff - <(finds "$folder") << END
README.md: $((most + 1)) lines, at most $most
README.md: no docs/gone.md
README.md: no x.png
docs/one.md: no heading for #the-rest
docs/one.md: no README.md
docs/two.md: no heading for one.md#a-commentnowhere
docs/two.md:3:@TIMES@
docs/two.md:3: does not say what one can do after it
README.md: does not link docs/two.md
END

mkdir "$folder/scripts"
cp "$root/scripts/lib.sh" "$folder/scripts"
printf '| a | 1 | 9 s |\n' > "$folder/docs/table.md"
printf '| a | 1 | 8 s |\n| --- | --- | --- |\n| a | 10 | 9 s |\nwords\n' > "$folder/table"
diff - <(bash -c "source '$folder/scripts/lib.sh'; on_page table.md 2" < "$folder/table" 2>&1) << 'END'
| a | 1 | 8 s |
| --- | --- | --- |
| a | 10 | 9 s |
== docs/table.md says otherwise: | a | 10 |
words
END

found=$(finds "$root")
[[ ! $found ]] || { echo "$found" && exit 1; }
echo "links lead somewhere, README is short"
