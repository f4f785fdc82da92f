# shellcheck shell=bash
# A hidden display to render a window on.
#   hidden_display FOLDER WIDTHxHEIGHT...  starts Xvfb with these screens and a free display's name.
#                                          Sets `display`, and `xvfb`, the process for the caller to
#                                          end; leaves files in FOLDER. 1, with a log, if it fails.
hidden_display() {
  local folder=$1 size screens=() number=0
  shift
  for size in "$@"; do
    screens+=(-screen "$number" "${size}x24")
    number=$((number + 1))
  done
  mkfifo "$folder/display"
  # Once ready it says which display it has found. Where no client is left it would begin anew, in
  # the way of the next.
  Xvfb -displayfd 3 -noreset -nolisten tcp "${screens[@]}" \
    3> "$folder/display" > "$folder/xvfb.log" 2>&1 &
  # shellcheck disable=SC2034  # these are for the caller
  xvfb=$!
  read -r -t 60 display < "$folder/display" || { cat "$folder/xvfb.log" >&2 && return 1; }
  display=:$display
  # A program that could take the desktop's display is not to.
  unset WAYLAND_DISPLAY
}
