# shellcheck shell=bash
# For tests of a program of somebody's own designs: as head.sh, `folder` being the present one, and
# what the program is asked and says.
# shellcheck source=tests/support/head.sh
source "$(dirname "${BASH_SOURCE[0]}")/head.sh"
before=$PWD
cd "$folder"
program=${program-} chosen=()

# program_of TARGET SOURCES --built FOLDER | --program PROGRAM [NAME...]: `program` is PROGRAM, or made
# of the project in SOURCES against the harness that was built in FOLDER. `chosen` are the NAMEs, and
# with one the project builds these alone.
program_of() {
  local from
  chosen=("${@:5}")
  from=$(cd "$before" && realpath "$4")
  case $3 in
    --program) program=$from ;;
    --built) build_program "$1" "$from" "$2" "-DONLY=$(IFS=';' && echo "${chosen[*]}")" ;;
    *) echo "needs --built FOLDER or --program PROGRAM" && exit 1 ;;
  esac
}
# build_program TARGET BUILD SOURCES [OPTION...]: installs the harness that was built in BUILD, and
# builds against it, all files at once, for the headers cost more than the designs.
build_program() {
  cmake --install "$2" --prefix "$folder/prefix" > "$folder/log"
  if ! cmake -S "$3" -B "$folder/build" -G Ninja "-DCMAKE_PREFIX_PATH=$folder/prefix" \
    -DCMAKE_UNITY_BUILD=ON "${@:4}" > "$folder/log" 2>&1 ||
    ! cmake --build "$folder/build" -j "$(nproc)" >> "$folder/log" 2>&1; then
    tail -50 "$folder/log"
    exit 1
  fi
  program=$folder/build/$1
}

# ends STATUS WORDS...: the program, which has no display, ends with that status; what it says is in
# `said`.
ends() {
  local wanted=$1 status=0
  shift
  DISPLAY='' WAYLAND_DISPLAY='' "$program" "$@" > said 2>&1 || status=$?
  [[ $status == "$wanted" ]] || fails "'$*' ends with $wanted; it is $status"
}
# says TEXT: a line with that text was said. says_not TEXT: none was.
says() { grep -qF -- "$1" said || fails "it says: $1"; }
says_not() { ! grep -qF -- "$1" said || fails "it says nothing of: $1"; }
# says_like REGEX: a line like that was.
says_like() { grep -qE -- "$1" said || fails "it says: $1"; }
