#!/usr/bin/env bash
# view_test.sh PROGRAM [COSIM ARGUMENTS...]: draws a wave and has GTKWave load its view. $COSIM_VARIANT
# names a variant for a program that takes one, and must then be found.
# Status: that of load_views.sh.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
expected=0 status=0
[[ -z ${COSIM_VARIANT-} ]] || expected=1
"$@" --wave "$folder/w.fst" --failures "$folder" || status=$?
((status == expected)) || exit 1
if ((status == 1)); then
  grep -q '^-First difference: ' "$folder/w.gtkw" ||
    { echo "the view does not show the mismatch"; exit 1; }
fi
"$(dirname "$0")/load_views.sh" "$folder/w.gtkw"
