#!/usr/bin/env bash
# load_views.sh FILE.gtkw...: has GTKWave load each view, on hidden screens. Every signal of
# the view must be found, and its picture must not be empty.
# Status: 0 all loaded; 1 not, each with its reason; 77, saying so, without GTKWave or Xvfb.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/xvfb.sh"
for tool in gtkwave Xvfb; do
  command -v "$tool" > /dev/null || { echo "skipped: there is no $tool"; exit 77; }
done
folder=$(mktemp -d) xvfb=
trap '[[ -z $xvfb ]] || kill "$xvfb" || true; rm -rf "$folder"' EXIT

# A screen for each GTKWave of those at a time, or one would cover the other.
screens=(1480x1000 1480x1000 1480x1000 1480x1000)
hidden_display "$folder" "${screens[@]}" || exit 1

cat > "$folder/load.tcl" << 'TCL'
set file [open $::env(loaded) w]
for {set i 0} {$i < [gtkwave::getTotalNumTraces]} {incr i} {
  puts $file [gtkwave::getTraceNameFromIndex $i]
}
close $file
gtkwave::/File/Grab_To_File $::env(picture)
gtkwave::/File/Quit
TCL

# load FILE.gtkw NAME: prints what is wrong. A view names its files as they lie beside it.
load() {
  local view=$1
  local wave=${view%.gtkw}.fst
  export loaded=$2.loaded picture=$2.png
  (cd "$(dirname "$view")" && timeout 60 gtkwave -S "$folder/load.tcl" "${wave##*/}" "${view##*/}") \
    > "$2.log" 2>&1 || true
  [[ -f $loaded ]] || { cat "$2.log"; return; }
  sed -n 's/^+{\(.*\)} .*/\1/p' "$view" | sort > "$2.wanted"
  [[ -s $2.wanted ]] || echo "has no signals"
  sort "$loaded" | comm -23 "$2.wanted" - | sed 's/^/GTKWave did not find: /'
  (($(stat -c %s "$picture") > 10000)) || echo "the picture is empty"
}

views=("$@")
for ((k = 0; k < ${#screens[@]}; ++k)); do
  for ((i = k; i < ${#views[@]}; i += ${#screens[@]})); do
    DISPLAY=$display.$k load "${views[i]}" "$folder/$i" 2>&1 | sed "s|^|${views[i]}: |"
  done > "$folder/wrong.$k" &
  loading+=($!)
done
wait "${loading[@]}"
if cat "$folder"/wrong.* | grep .; then exit 1; fi
echo "${#views[@]} views, $(cat "$folder"/*.wanted | wc -l) signals"
