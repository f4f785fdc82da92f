#!/usr/bin/env bash
# README and the pages of docs/ are short, docs/index.md links every page, and .mkdocs.yml lists it. Every
# relative link leads to a file and, behind a #, to a heading of it. Each page begins with what the reader
# can do after it, and none has a @PLACE@ that is still to be filled in. Fewer than 2 % of the sentences
# begin with Of, Where, What, Who, That or So. First on a small tree where each is wrong, then on the
# project. And a script whose table a page has says which row differs.
# Status: 0 so it is, 1 not, with a line for each find.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
most=130 most_of_page=200 most_fronted=2
sentences=$root/tests/scripts/sentences.awk

# text FILE: its lines outside of fenced blocks, without `code`.
text() { awk '/^```/ { fenced = !fenced; next } !fenced { gsub(/`[^`]*`/, ""); print }' "$1"; }

# links FILE: the targets of its relative links, a line each.
links() { text "$1" | grep -oE '\]\([^)[:space:]]+' | sed 's/^](//' | grep -vE '^[a-z]+:' || true; }

# anchors FILE: what a #part may say of it, a line for each heading.
anchors() {
  awk '/^```/ { fenced = !fenced } /^#+ / && !fenced { sub(/^#+ /, ""); print }' "$1" |
    tr '[:upper:]' '[:lower:]' | sed 's/[^a-z0-9 _-]//g; s/ /-/g'
}

# snippets PAGE: its C++, a line for each part between dots, with the number of its first line in front;
# without comments and blanks, as flat FILE.
snippets() {
  awk '
    function part() { if (text != "") printf "%d\t%s\n", at, text; text = "" }
    /^```/ { if (inside) part(); inside = /^```cpp/; next }
    inside && /^\.\.\.$/ { part(); next }
    inside { if (text == "") at = NR; sub(/\/\/.*/, ""); gsub(/[ \t]/, ""); text = text $0 }' "$1"
}
flat() { sed 's://.*::' "$1" | tr -d '[:space:]' && echo; }

# fronted FILE...: how many sentences of all begin with another word than the subject, if too many do.
fronted() {
  local all=$folder/sentences some=$folder/fronted
  awk -f "$sentences" "$@" > "$all"
  grep -P '\t(Of|Where|What|Who|That|So)\b' "$all" > "$some" || true
  awk -v some="$(wc -l < "$some")" -v most="$most_fronted" '
    END { if (100 * some >= most * NR) printf "%d of %d sentences are fronted\n", some, NR }' "$all"
}

finds() {
  cd "$1"
  local page target file lines limit number part pages=() compiled=$folder/compiled
  { find examples tests \( -name '*.h' -o -name '*.cpp' \) 2> /dev/null || true; } |
    while read -r file; do flat "$file"; done > "$compiled"
  mapfile -t pages < <(find docs -name '*.md' | LC_ALL=C sort)
  for page in README.md "${pages[@]}"; do
    lines=$(wc -l < "$page")
    limit=$most_of_page
    [[ $page != README.md ]] || limit=$most
    ((lines <= limit)) || echo "$page: $lines lines, at most $limit"
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
    while IFS=$'\t' read -r number part; do
      grep -qF -- "$part" "$compiled" || echo "$page:$number: C++ that no file of examples/ or tests/ has"
    done < <(snippets "$page")
    [[ $page == README.md || $(sed -n 3p "$page") == "After this page you "* ]] ||
      echo "$page:3: does not say what one can do after it"
    [[ $page != docs/* ]] || grep -qE ": ${page#docs/}\$" .mkdocs.yml || echo ".mkdocs.yml: does not list $page"
    [[ $page != docs/*/* ]] || grep -qE "^${page#docs/}(#|\$)" <(links docs/index.md) ||
      echo "docs/index.md: does not link $page"
  done
  fronted README.md "${pages[@]}"
}

mkdir -p "$folder/docs/sub"
{
  echo '[one](docs/one.md), [gone](docs/gone.md), ![picture](x.png), [far](https://example.org/x)'
  echo "\`[code](nowhere)\`"
  seq "$((most - 1))"
} > "$folder/README.md"
cat > "$folder/docs/index.md" << 'END'
# Index

After this page you know [two](sub/two.md). Of three pages one is here. So it is.
END
cat > "$folder/docs/one.md" << 'END'
# One

After this page you know two, [here](#the-rest-of-it-2) and [there](#the-rest), not [none](README.md).

```sh
# [a comment](nowhere)
```

## The rest of `it`: 2
END
mkdir "$folder/tests"
printf 'int a;  // one\nint b;\nint c;\n' > "$folder/tests/a.h"
cat >> "$folder/docs/one.md" << 'END'
```cpp
int a;
int  b;
...
int c; // another
```
```cpp
int a;
int c;
```
END
printf '# Two\n\n@TIMES@, [one](../one.md#one), [code](../one.md#a-commentnowhere)\n' > "$folder/docs/sub/two.md"
{ printf '# Long\n\nAfter this page you sleep.\n' && seq "$((most_of_page - 2))"; } > "$folder/docs/sub/long.md"
printf '%s\n' 'nav:' '  - One: one.md' '  - Index: index.md' '  - Long: sub/long.md' > "$folder/.mkdocs.yml"
diff - <(finds "$folder") << END
README.md: $((most + 1)) lines, at most $most
README.md: no docs/gone.md
README.md: no x.png
docs/one.md: no heading for #the-rest
docs/one.md: no README.md
docs/one.md:17: C++ that no file of examples/ or tests/ has
docs/sub/long.md: $((most_of_page + 1)) lines, at most $most_of_page
docs/index.md: does not link docs/sub/long.md
docs/sub/two.md: no heading for ../one.md#a-commentnowhere
docs/sub/two.md:3:@TIMES@
docs/sub/two.md:3: does not say what one can do after it
.mkdocs.yml: does not list docs/sub/two.md
2 of 8 sentences are fronted
END
diff - "$folder/fronted" <<- 'END'
	docs/index.md:3	Of three pages one is here.
	docs/index.md:3	So it is.
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
[[ ! $found ]] || { echo "$found" && [[ $found != *fronted* ]] || cat "$folder/fronted" && exit 1; }
printf '%s of %s sentences are fronted; links lead somewhere, pages are short\n' \
  "$(wc -l < "$folder/fronted")" "$(wc -l < "$folder/sentences")"
