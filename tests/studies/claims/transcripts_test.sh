#!/usr/bin/env bash
# transcripts_test.sh PROGRAM VARIANT_PROGRAM: what README and the pages of docs/ show as printed is what
# is printed. In a block of the language console a line "$ COMMAND" is run and must print the lines
# below it; a block behind a line "<!-- prints: COMMAND -->" is all that this prints. A line "..." stands
# for any lines. COMMAND is `cosim ARGUMENTS`, or scripts/cosim, or `cat FILE`; with COSIM_VARIANT=NAME
# before it the RTL has that fault. The commands of a page share a folder. First on pages that are wrong.
# Status: 0 so it is, 1 not, with what is printed in place of what is shown.
source "$(dirname "${BASH_SOURCE[0]}")/../../support/head.sh"
program=$(realpath "$1") variant=$(realpath "$2")
unset COSIM_VARIANT COSIM_FAILURES

# run COMMAND: it, in the folder of the page.
run() {
  local words one=$program
  read -ra words <<< "$1"
  if [[ ${words[0]} == COSIM_VARIANT=* ]]; then
    one=$variant
    export "${words[0]}"
    words=("${words[@]:1}")
  fi
  case ${words[0]} in
    # By the name that the page has.
    cosim | scripts/cosim) (exec -a "${words[0]}" "$one" "${words[@]:1}") ;;
    cat) cat "${words[@]:1}" ;;
    *) echo "is no command for this test: $1" ;;
  esac
}

# agrees COMMAND SHOWN: whether it prints that, else both.
agrees() {
  local line quoted pattern="" printed
  while IFS= read -r line; do
    quoted=$'\n' # '%q' makes quotes of an empty line
    [[ ! $line ]] || printf -v quoted '%q\n' "$line"
    [[ $line == "..." ]] && pattern+="*" || pattern+=$quoted
  done <<< "${2%$'\n'}"
  printed=$(run "$1" 2>&1 || true)$'\n'
  # shellcheck disable=SC2053
  [[ $printed == $pattern ]] && return
  diff <(printf '%s' "$2") <(printf '%s' "$printed") || true
}

# finds PAGE: a line for each command that prints something else, and how they differ.
finds() {
  local page line fenced="" command="" shown="" number=0 at=0 told=""
  page=$(basename "$1")
  finish() {
    [[ ! $command ]] || told=$(agrees "$command" "$shown")
    [[ ! $told ]] || printf '%s:%d: %s\n%s\n' "$page" "$at" "$command" "$told"
    command="" shown="" told=""
  }
  while IFS= read -r line; do
    ((++number))
    if [[ $line == '```'* ]]; then
      if [[ $fenced ]]; then
        finish
        fenced=""
      else
        fenced=${line#'```'} fenced=${fenced:-plain}
      fi
    elif [[ ! $fenced && $line =~ ^"<!-- prints: "(.*)" -->"$ ]]; then
      command=${BASH_REMATCH[1]} at=$number
    elif [[ $fenced == console && $line == '$ '* ]]; then
      finish
      command=${line#'$ '} at=$number
    elif [[ $fenced && $command ]]; then
      shown+=$line$'\n'
    fi
  done < "$1"
}

# all PAGE...: the same of some pages, each in a folder of its own where it finds the project's files.
all() {
  local page work
  for page; do
    work=$(mktemp -d -p "$folder")
    ln -s "$root/tests" "$work/tests"
    page=$(realpath "$page")
    (cd "$work" && finds "$page")
  done
}

cat > "$folder/page.md" << 'END'
```console
$ cosim examples
...
  cosim arc --radius 12 --width 4 --table
...
$ cosim arc --width
cosim: --width: needs a number
$ cosim arc --width
cosim: --width: needs a value
```
<!-- prints: scripts/cosim line --major -->
```
...
so it is not
...
```
```
$ cosim nothing
```
END
diff - <(all "$folder/page.md") << 'END'
page.md:6: cosim arc --width
1c1
< cosim: --width: needs a number
---
> cosim: --width: needs a value
page.md:11: scripts/cosim line --major
1,3c1
< ...
< so it is not
< ...
---
> cosim: --major: needs a value
END

cd "$root"
mapfile -t pages < <(find docs -name '*.md' | LC_ALL=C sort)
found=$(all README.md "${pages[@]}")
[[ ! $found ]] || { echo "$found" && exit 1; }
echo "what is shown is printed"
