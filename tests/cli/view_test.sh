#!/usr/bin/env bash
# view_test.sh PROGRAM [COSIM ARGUMENTS...]: draws a wave and has GTKWave load its view: every signal
# of the view must be found, and the picture must not be empty. $COSIM_VARIANT names a variant for a
# program that takes one. Status 77, with a word why, where there is no GTKWave or no Xvfb.
set -euo pipefail
for tool in gtkwave xvfb-run; do
  command -v "$tool" > /dev/null || { echo "skipped: there is no $tool"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export COSIM_FAILURES=$folder/failures

status=0
"$@" --wave w.fst || status=$?
((status < 2))
cat > load.tcl << 'TCL'
set file [open loaded w]
for {set i 0} {$i < [gtkwave::getTotalNumTraces]} {incr i} {
  puts $file [gtkwave::getTraceNameFromIndex $i]
}
close $file
gtkwave::/File/Grab_To_File picture.png
gtkwave::/File/Quit
TCL
timeout 60 xvfb-run --auto-servernum gtkwave -S load.tcl w.fst w.gtkw > log 2>&1 || { cat log; exit 1; }

sed -n 's/^+{\(.*\)} .*/\1/p' w.gtkw | sort > wanted
sort loaded | comm -23 wanted - > lost
[[ -s wanted ]] || { echo "the view has no signals"; exit 1; }
[[ ! -s lost ]] || { echo "GTKWave did not find:" && cat lost && exit 1; }
(($(stat -c %s picture.png) > 10000)) || { echo "the picture is empty"; exit 1; }
if ((status == 1)); then
  grep -q '^-First difference: ' w.gtkw || { echo "the view does not show the mismatch"; exit 1; }
fi
echo "$(wc -l < wanted) signals"
