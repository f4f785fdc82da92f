#!/usr/bin/env bash
# Every script of scripts/ prints its purpose, the same with -h and --help, without any package or
# build. Also after other words, unless the script passes its words on.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"

for script in "$root"/scripts/*; do
  [[ -x $script ]] || continue
  name=$(basename "$script")
  long=$("$script" --help < /dev/null)
  [[ $long == "scripts/$name"* ]] || { echo "$name --help says: $long" && exit 1; }
  [[ $("$script" -h < /dev/null) == "$long" ]] || { echo "$name -h says another thing" && exit 1; }
  case $name in
    cosim | test) continue ;;
    setup) word=run ;;
    fuzz) word=gcode ;;
    mutate) word=--slice ;;
    *) word=linear ;;
  esac
  [[ $("$script" "$word" --help < /dev/null) == "$long" ]] ||
    { echo "$name $word --help says another thing" && exit 1; }
done
echo "all help"
