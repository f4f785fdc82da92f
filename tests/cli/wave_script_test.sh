#!/usr/bin/env bash
# wave_script_test.sh PROGRAM: what `PROGRAM wave` and scripts/wave render without a display, and what they
# refuse, in one clear line, with status 2. Status 77 where it cannot be tried.
# Needs: circular
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs gtkwave Xvfb
unset DISPLAY WAYLAND_DISPLAY

# rendered NAME COMMAND...: with --shot it makes a picture that is not empty, and GTKWave keeps nothing at home.
rendered() {
  local picture=$folder/$1.png
  HOME=$folder/home "${@:2}" --shot "$picture"
  [[ ! -e $folder/home/.cache/dconf ]] || fails "GTK keeps its settings at home"
  [[ $(head -c 4 "$picture" | tail -c 3) == PNG && $(stat -c %s "$picture") -gt 10000 ]] ||
    { echo "${*:2} --shot $picture: no picture" && exit 1; }
}
mkdir "$folder/failure" "$folder/home"
"$1" arc --radius 12 --wave "$folder/failure/wave.fst" > "$folder/said"
rendered wave "$1" wave "$folder/failure/wave.fst"
(cd "$folder" && rendered drawn "$1" wave circular W=4 --hostile 20 --out drawn.fst)
[[ -f $folder/drawn.gtkw ]]

# refused LINE COMMAND...: that is all that it says, and its status is 2.
refused() {
  local said status=0
  said=$("${@:2}" 2>&1) || status=$?
  [[ $status == 2 && $said == "$1" ]] && return
  printf '%s: status %d, it said\n%s\nin place of\n%s\n' "${*:2}" "$status" "$said" "$1"
  exit 1
}
export COSIM_FAILURES=$folder/none
shot=(--shot "$folder/shot.png") wave=$folder/failure/wave.fst
refused "cosim: there is no display; --shot FILE.png and --out FILE.fst draw without one" "$1" wave "$wave"
refused "cosim: --shot: shot.gif does not end in .png" "$1" wave "$wave" --shot shot.gif
refused "cosim: --shot: there is no folder $folder/none" "$1" wave "$wave" --shot "$folder/none/shot.png"
refused "cosim: $wave: is drawn already" "$1" wave "$wave" --out again.fst
rm "$folder/drawn.gtkw"
refused "cosim: $folder/drawn.gtkw: no such file; it is the view of $folder/drawn.fst" \
  "$1" wave "$folder/drawn.fst" "${shot[@]}"

script=$root/scripts/wave
refused "wave: --shot needs a name" "$script" --shot
refused "wave: --shot needs a name" "$script" arc --radius 12 --shot
refused "wave: no such option: --size" "$script" --size
refused "wave: no such option: --size" "$script" "$folder" --size
refused "wave: one thing at a time: $folder $folder" "$script" "${shot[@]}" "$folder" "$folder"
# It builds the program first, which is here already.
if [[ $1 == "$root/build/cosim" ]]; then
  rendered arc "$script" arc --radius 12
  rendered folder "$script" "$folder/failure"
  cmp "$folder/folder.png" "$folder/wave.png"
  refused "cosim: $folder/none: no failure is kept there; name a stimulus or a design" "$script" "${shot[@]}"
  refused "cosim: --radius: is needed, or --radius2" "$script" "${shot[@]}" arc
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
