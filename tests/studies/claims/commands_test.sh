#!/usr/bin/env bash
# commands_test.sh PROGRAM: every command that README and the pages of docs/ show is there, with every
# option that is shown with it, by the --help of PROGRAM and of the scripts; so is every option that a
# sentence names, and every file and folder. Words in capitals stand for anything. First on a page where
# each is wrong, then on the project.
# Status: 0 so it is, 1 not, with a line for each find.
source "$(dirname "${BASH_SOURCE[0]}")/../../support/head.sh"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
program=$(realpath "$1")
cd "$root"

# commands_in HELP: the names of the commands that a help lists.
commands_in() { sed -n '/^subcommands:/I,/^$/s/^  \([a-z]*\) .*/\1/p' <<< "$1"; }

# help["COMMAND"], help["sweep NAME"], help["scripts/NAME"]
declare -A help
top=$("$program" --help)
for command in $(commands_in "$top"); do
  help[$command]=$("$program" "$command" --help)
  for name in $(commands_in "${help[$command]}"); do
    help["$command $name"]=$("$program" "$command" "$name" --help)
  done
done
for script in scripts/*; do
  [[ ! -x $script ]] || help[$script]=$("$script" --help < /dev/null)
done
all=$(printf '%s\n' "${help[@]}")

# lacks HELP TEXT: the options in the text that the help does not name.
lacks() {
  local option
  while read -r option; do
    grep -qE -- "(^|[^a-z-])$option([^a-z0-9-]|\$)" <<< "$1" || echo "$option"
  done < <(grep -oE '(^| )--[a-z][a-z0-9-]*' <<< "$2")
}

# below COMMAND NAME PROGRAM: the help of what stands below a command, of all where it is no NAME of ours.
below() {
  local key
  if [[ -v help["$1 $2"] ]]; then
    echo "${help["$1 $2"]}"
  elif [[ $3 == *_cosim || ! $2 =~ ^[a-z]+$ ]]; then
    for key in "${!help[@]}"; do
      [[ $key != "$1 "* ]] || echo "${help[$key]}"
    done
  fi
}

# wrong TEXT: what is wrong with a command, a line each.
wrong() {
  local words known word
  read -ra words <<< "$1"
  known=${help[${words[0]}]-}
  word=${words[1]-}
  if [[ ${words[0]} == scripts/* && ! $known ]]; then
    echo "there is no ${words[0]}"
    return
  elif [[ ${words[0]} != scripts/* || ${words[0]} == scripts/cosim ]]; then
    [[ $word =~ ^[a-z]+$ && $word != help ]] || { lacks "$known$top" "$1" && return; }
    if [[ ${words[0]} == *_cosim && ! -v help[$word] && -f tb/cli/$word.cpp ]]; then
      # Of programs of somebody else alone: its options stand in its source.
      help[$word]=$(< "tb/cli/$word.cpp")
    fi
    [[ -v help[$word] ]] || { echo "there is no command $word" && return; }
    known+=${help[$word]}$(below "$word" "${words[2]-}" "${words[0]}")
  else
    # Some scripts pass their words on.
    for word in "${words[0]#scripts/}" "${words[@]:1}"; do
      known+=${help[$word]-}
    done
  fi
  lacks "$known" "$1"
}

# finds FILE...: a line for each thing shown that is not there.
finds() {
  local at kind text find
  while IFS=$'\t' read -r at kind text; do
    case $kind in
      command) find=$(wrong "$text" | sed "s|^|$text: |") ;;
      option) find=$(lacks "$all" "$text") ;;
      path) compgen -G "$(sed -E 's/[A-Z]{3,}/*/g' <<< "$text")" > /dev/null && find="" || find="no $text" ;;
    esac
    [[ ! $find ]] || printf '%s: %s\n' "$at" "${find//$'\n'/$'\n'$at: }"
  done < <(awk -f "$here/shown.awk" "$@")
}

cat > "$folder/page.md" << 'END'
`scripts/cosim arc --radius 12`, `cosim arc --radiu 12`, `cosim line`, `cosim lines`, `--table`, `--tabl`,
`scripts/none`, `scripts/prove --limit 3 --limits 3`, `rtl/NAME/NAME.v`, `rtl/linear/liner.v`.
```sh
scripts/cosim sweep linear --exhaustive   # --nothing
COSIM_LANES_ALL=1 build/cosim sweep linear --exhausted && scripts/test --presets asan
build/uart_cosim sweep uart --hostile 10
build/uart_cosim sweep uart --hostil 10
~/cosim/bin/cosim news uart
```
```console
$ cosim arc --count
--count 3
```
```
scripts/wave --shots FILE
cosim stimulus 1
```
END
diff - <(finds "$folder/page.md" | sed 's|.*/page.md|page.md|') << 'END'
page.md:1: cosim arc --radiu 12: --radiu
page.md:1: cosim lines: there is no command lines
page.md:1: --tabl
page.md:2: scripts/none: there is no scripts/none
page.md:2: no scripts/none
page.md:2: scripts/prove --limit 3 --limits 3: --limits
page.md:2: no rtl/linear/liner.v
page.md:5: build/cosim sweep linear --exhausted: --exhausted
page.md:5: scripts/test --presets asan: --presets
page.md:7: build/uart_cosim sweep uart --hostil 10: --hostil
page.md:8: ~/cosim/bin/cosim news uart: there is no command news
page.md:15: scripts/wave --shots FILE: --shots
END

mapfile -t pages < <(find docs -name '*.md' | LC_ALL=C sort)
found=$(finds README.md "${pages[@]}")
[[ ! $found ]] || { echo "$found" && exit 1; }
echo "all that is shown is there"
