# shellcheck shell=bash
# For tests of a program of somebody's own designs: a folder `scratch`, which is the present one and
# goes with the script, and what the program is asked and says.
before=$PWD
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
program='' chosen=()

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
  cmake --install "$2" --prefix "$scratch/prefix" > "$scratch/log"
  if ! cmake -S "$3" -B "$scratch/build" -G Ninja "-DCMAKE_PREFIX_PATH=$scratch/prefix" \
    -DCMAKE_UNITY_BUILD=ON "${@:4}" > "$scratch/log" 2>&1 ||
    ! cmake --build "$scratch/build" -j "$(nproc)" >> "$scratch/log" 2>&1; then
    tail -50 "$scratch/log"
    exit 1
  fi
  program=$scratch/build/$1
}

# fails TEXT...: what was not so, and what was said last.
fails() {
  cat said
  printf 'not so: %s\n' "$*"
  exit 1
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
