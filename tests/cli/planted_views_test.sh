#!/usr/bin/env bash
# planted_views_test.sh PROGRAM DESIGN: hostile clocks find each fault that is planted in the design,
# each misprint too, and both views of the folder that is left show it. GTKWave loads the view of each
# smallest stimulus, and of the first fault the one of the whole case.
# Status: that of load_views.sh.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
program=$1 design=$2 views=()
variants=$(cd "$(dirname "${BASH_SOURCE[0]}")/../designs/$design/rtl/variants" && pwd)

for spec in "$variants"/{faults,errata}/*.cmake; do
  name=$design/${spec#"$variants/"}
  name=${name%.cmake}
  kept=$folder/${name//\//.}
  status=0
  COSIM_VARIANT=$name "$program" sweep "$design" --hostile 100000 --failures "$kept" \
    > "$folder/said" || status=$?
  ((status == 1)) || { echo "$name: status $status" && cat "$folder/said" && exit 1; }
  for view in "$kept"/*/{wave,smallest}.gtkw; do
    grep -q '^-First difference: ' "$view" ||
      { echo "$name: $(basename "$view") does not show the mismatch"; exit 1; }
    [[ $view == */wave.gtkw && ${views[*]} ]] || views+=("$view")
  done
done
echo "$((${#views[@]} - 1)) faults"
"$(dirname "$0")/load_views.sh" "${views[@]}"
