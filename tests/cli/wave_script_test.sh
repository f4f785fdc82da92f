#!/usr/bin/env bash
# wave_script_test.sh PROGRAM: scripts/wave renders a wave that PROGRAM draws, and with nothing to draw
# says so in one clear line, with status 2. Status 77 where it cannot be tried.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
for tool in gtkwave Xvfb; do
  command -v "$tool" > /dev/null || { echo "skipped: there is no $tool"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset DISPLAY WAYLAND_DISPLAY

# rendered ARGUMENTS...: scripts/wave makes a picture that is not empty.
rendered() {
  local picture=$folder/$1.png
  "$root/scripts/wave" --shot "$picture" "${@:2}"
  [[ $(head -c 4 "$picture" | tail -c 3) == PNG && $(stat -c %s "$picture") -gt 10000 ]] ||
    { echo "scripts/wave --shot $picture ${*:2}: no picture" && exit 1; }
}

mkdir "$folder/failure"
"$1" arc --radius 12 --wave "$folder/failure/wave.fst" > "$folder/said"
rendered folder "$folder/failure"
# By name it builds the program first, which is here already.
[[ $1 != "$root/build/cosim" ]] || rendered arc arc --radius 12
# Options stand before the words or behind them.
"$root/scripts/wave" "$folder/failure" --shot "$folder/behind.png"
cmp "$folder/behind.png" "$folder/folder.png"

# refused LINE ARGUMENTS...: that is all that scripts/wave says, and its status is 2.
refused() {
  local line="wave: $1" said status=0
  shift
  said=$("$root/scripts/wave" "$@" 2>&1) || status=$?
  [[ $status == 2 && $said == "$line" ]] && return
  printf 'scripts/wave %s: status %d, it said\n%s\nin place of\n%s\n' "$*" "$status" "$said" "$line"
  exit 1
}

shot=(--shot "$folder/shot.png")
export COSIM_FAILURES=$folder/none
refused "there is no failure in $folder/none" "${shot[@]}"
refused "$folder: is no folder of a failure" "${shot[@]}" "$folder"
refused "there is no display; --shot FILE.png renders without one" "$folder"
refused "--shot: shot.gif does not end in .png" --shot shot.gif
refused "--shot: there is no folder $folder/none" --shot "$folder/none/shot.png"
refused "--shot needs a name" --shot
refused "--shot needs a name" arc --radius 12 --shot
refused "no such option: --size" --size
refused "no such option: --size" "$folder" --size
refused "one thing at a time: $folder $folder" "${shot[@]}" "$folder" "$folder"
# What the program refuses it says itself.
if [[ $1 == "$root/build/cosim" ]]; then
  line="cosim: --radius: is needed, or --radius2"
  said=$("$root/scripts/wave" "${shot[@]}" arc 2>&1) && status=0 || status=$?
  [[ $status == 2 && $said == "$line" ]] ||
    { printf 'scripts/wave arc: status %d, it said\n%s\n' "$status" "$said" && exit 1; }
fi

# A machine without GTKWave, and nothing to install it with.
mkdir "$folder/bin"
for tool in bash basename dirname sed env sort comm paste; do
  ln -s "$(command -v "$tool")" "$folder/bin/$tool"
done
printf '#!/bin/sh\n' > "$folder/bin/dpkg-query"
chmod +x "$folder/bin/dpkg-query"
said=$(PATH=$folder/bin "$root/scripts/wave" arc --radius 12 2>&1) && status=0 || status=$?
[[ $status == 2 && $said == "setup: no apt-get to install what is missing: "*gtkwave* &&
  $(wc -l <<< "$said") == 1 ]] ||
  { printf 'without GTKWave: status %d, it said\n%s\n' "$status" "$said" && exit 1; }
echo "rendered or refused"
