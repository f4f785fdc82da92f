#!/usr/bin/env bash
# browser_test.sh PROGRAM FAULTY PICTURES: opens pages in a headless Chromium, each in light and dark
# and on a narrow window: that of a run with its path, of sweeps, of a failure (FAULTY has faulty
# benches), and the one that scripts/report gathers. Nothing may be said on the console, the page must
# not be wider than the window, all its figures must be drawn, and the clock of a difference must be
# in sight. The pictures go to the folder PICTURES.
# Status: 0 so it is; 1 not; 77, saying so, without Chromium.
# Needs: linear, circular
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
program=$1 faulty=$2 pictures=$3
browser=$(command -v chromium-headless-shell || command -v chromium) || {
  echo "skipped: no Chromium; scripts/setup page brings one"
  exit 77
}
mkdir -p "$pictures"

plot=()
command -v gnuplot > "$folder/log" && plot=(--plot "$folder/run.png")
"$program" arc --radius 12 --html "$folder/run.html" "${plot[@]}" > "$folder/log"
"$program" sweep linear --random 20 --html "$folder/sweeps.html" > "$folder/log"
"$faulty" line --major 3000 --minor 700 --failures "$folder/kept" > "$folder/log" && exit 1
cp "$folder"/kept/*/report.html "$folder/failure.html"
COSIM_FAILURES=$folder/kept "$root/scripts/report" --to "$folder/all.html" > "$folder/log"

# What a page looks like from inside: whether it fits, its background, how many of its figures are
# drawn, and whether what is marked in the first of them is in sight.
look='<script>
  const sees = box => box.width > 0 && box.left >= 0 && box.right <= innerWidth
  const figures = [...document.querySelectorAll(".wave, svg.path, table, pre, img")]
  const marks = [...document.querySelectorAll(".mark")].slice(0, 1)
  addEventListener("load", () => console.log(
    "LOOK fits", document.documentElement.scrollWidth <= innerWidth,
    "light", getComputedStyle(document.body).backgroundColor === "rgb(255, 255, 255)",
    "drawn", figures.length > 0 && figures.every(
      f => !f.checkVisibility() || f.getBoundingClientRect().height > 20) &&
      [...document.images].every(i => i.naturalWidth > 20),
    "inside", [...document.querySelectorAll(".wave text")].every(t => t.getBBox().width > 0),
    "marked", marks.every(m => sees(m.getBoundingClientRect())), marks.length))
</script>'

status=0
wrong() { echo "$*" && status=1; }
# opened NAME KIND WIDTH OPTION...: the page NAME in a window, and its picture NAME.KIND.png.
opened() {
  local name=$1 kind=$2 width=$3 light=true said marks=0
  shift 3
  [[ $kind != dark ]] || light=false
  [[ $name != failure ]] || marks=1
  timeout 60 "$browser" --no-sandbox --disable-gpu --hide-scrollbars --enable-logging=stderr \
    --user-data-dir="$folder/user" --window-size="$width,2400" \
    --screenshot="$pictures/$name.$kind.png" "$@" "file://$folder/$name.look.html" \
    > "$folder/said" 2>&1 || wrong "$name, $kind: could not be opened"
  said=$(grep -a CONSOLE "$folder/said" | sed 's/, source: .*//; s/.*CONSOLE[^"]*//') || true
  [[ $said == "\"LOOK fits true light $light drawn true inside true marked true $marks\"" ]] ||
    wrong "$name, $kind: $said"
  [[ -s $pictures/$name.$kind.png ]] || wrong "$name, $kind: no picture"
}

for name in run sweeps failure all; do
  { cat "$folder/$name.html" && echo "$look"; } > "$folder/$name.look.html"
  opened "$name" light 1280
  opened "$name" dark 1280 --blink-settings=preferredColorScheme=0
  opened "$name" narrow 420
done
((status)) || echo "12 pictures in $pictures"
exit "$status"
