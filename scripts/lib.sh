# shellcheck shell=bash
# What the scripts share. A script sources it first: strict mode, the repository's root, and
#   say TEXT...          a heading on standard error
#   die TEXT...          one line on standard error; ends with status 2: could not be run
#   usage                the caller's opening comment, as its --help
#   help WORDS...        where one of the words is -h or --help: usage, and the end of the script
#   quietly COMMAND...   COMMAND, its output only where it fails; on a terminal, one moving line
#   compile WHAT FOLDER COMMAND...  COMMAND, which builds WHAT; its output stays in FOLDER/build.log, and
#                        where it fails one line says the first error and the log, with status 2
#   build PRESET TARGET  configures where needed, then builds, as compile; without a TARGET no more
#   ready PRESET TARGET SET...  installs these sets of scripts/setup, then builds; ends with status 2
#   help_with COMMAND WORDS...  as help, with what `cosim COMMAND` says of itself where it is built
#   make_scratch         sets scratch, a new folder that goes with the script
#   on_page PAGE COLUMNS copies a table in Markdown from standard input, and says of each row whether the
#                        page of docs/ has another one in the first COLUMNS columns
#   record NAME TITLE COMMAND  the rest of the script leaves what it prints for scripts/report
set -euo pipefail

arguments=("$@") # the caller's
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Tools of others cannot be given every name of a folder: abc of yosys takes none with a space.
[[ ${TMPDIR-} != *[!A-Za-z0-9_./+=,@%-]* ]] || export TMPDIR=/tmp

say() { printf '== %s\n' "$*" >&2; }

die() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 2
}

make_scratch() { scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT; }

usage() { sed -n '2,${/^#/!q; s/^# \{0,1\}//p}' "$0"; }

help() {
  local word
  for word; do
    [[ $word != -h && $word != --help ]] || { usage && exit; }
  done
}

help_with() {
  local word
  for word in "${@:2}"; do
    [[ $word == -h || $word == --help ]] || continue
    usage
    [[ ! -x $root/build/cosim ]] || { echo && "$root/build/cosim" "$1" --help; }
    exit
  done
}

# The last line of standard input so far, on one line of the terminal that is cleared at the end. Of
# ninja's "[12/345] ..." it says how far it is, and how long the rest will take.
moving_line() {
  local line made all began=$SECONDS
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
      made=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]}
      line="$made of $all made, about $(((SECONDS - began) * (all - made) / made + 1)) s left"
    fi
    printf '\r\033[K%.79s' "$line"
  done
  printf '\r\033[K'
}

# logged LOG COMMAND...: its output goes to the file LOG; on a terminal one moving line shows it.
logged() {
  if [[ -t 2 ]]; then
    "${@:2}" < /dev/null 2>&1 | tee "$1" | moving_line >&2
  else
    "${@:2}" < /dev/null > "$1" 2>&1
  fi
}

quietly() (
  log=$(mktemp)
  trap 'rm -f "$log"' EXIT
  logged "$log" "$@" && exit
  cat "$log" >&2
  exit 1
)

# first_error LOG: what failed in a log of CMake, of a compiler or of ninja, one line: the first error
# with its file, else the target that was not made, else the last line.
first_error() {
  local text error='' one words
  text=$(sed -E $'s/\e\\[[0-9;]*[mK]//g; s:^(/[^ ]*/)?(\\.\\./)+::' "$1")
  for one in '^[^ ]+:[0-9]+(:[0-9]+)?: (fatal )?error: ' '^CMake Error' 'undefined reference to ' \
    '^FAILED: ' '^%Error' '[^ ]'; do
    error=$(grep -m 1 -E -A 2 -- "$one" <<< "$text") || continue
    # The text of CMake's error is on the lines behind its place.
    [[ $error == 'CMake Error'* ]] || error=${error%%$'\n'*}
    break
  done
  read -rd '' -a words <<< "${error//"$root/"/}" || true
  error=${words[*]}
  printf '%s' "${error:0:300}"
}

compile() {
  local log=$2/build.log
  logged "$log" "${@:3}" || die "$1 is not built: $(first_error "$log"); its log: $log"
}

# configure PRESET FOLDER TARGET: where it was not done yet; or again, where CXX or COSIM_WERROR ask
# for something else, or a tool that CMake looks for has come or gone: ninja sees only files that
# change. The program alone is configured without the tests, until they are asked for.
configure() {
  local preset=$1 note=$2/.configured was=() now fresh=() tests=ON
  [[ ! -f $2/build.ninja || ! -f $note ]] || mapfile -t was < "$note"
  if [[ $3 == cosim ]]; then
    grep -qs '^BUILD_TESTING:BOOL=ON' "$2/CMakeCache.txt" || tests=OFF
  fi
  now=("${CXX-${was[0]-}}" "${COSIM_WERROR-${was[1]-}}" "$(command -v yosys || true)" "$tests")
  [[ ${#was[@]} == 0 || "${was[*]}" != "${now[*]}" ]] || return 0
  # Of another compiler nothing that was found holds.
  [[ ${was[0]-} == "${now[0]}" ]] || fresh=(--fresh)
  rm -f "$note"
  COSIM_WERROR=${now[1]} compile "${3:-all}" "$2" \
    cmake "${fresh[@]}" --preset "$preset" -DBUILD_TESTING="$tests" &&
    printf '%s\n' "${now[@]}" > "$note"
}

on_page() {
  local row cells
  while IFS= read -r row; do
    printf '%s\n' "$row"
    [[ $row == '|'* && $row != '| ---'* ]] || continue
    cells=$(cut -d '|' -f "1-$(($2 + 1))" <<< "$row")
    grep -qF -- "$cells|" "$root/docs/$1" || say "docs/$1 says otherwise: $cells|"
  done
}

# The lock is for two scripts at once.
build() (
  preset=$1 target=$2
  folder=$root/build
  [[ $preset == default ]] || folder+=/$preset
  if [[ -z ${CMAKE_CXX_COMPILER_LAUNCHER-} ]] && command -v ccache > /dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  { mkdir -p "$folder" && cd "$root" && exec 9> "$folder/.lock" && flock 9; } || exit 2
  configure "$preset" "$folder" "$target"
  [[ ! $target ]] || compile "$target" "$folder" cmake --build --preset "$preset" --target "$target" -j "$(nproc)"
)

ready() {
  "$root/scripts/setup" "${@:3}" || exit
  build "$1" "$2" || exit
}

# record NAME TITLE COMMAND: runs the caller once more, with its own arguments, below this one, and
# ends with its status. What that prints is printed, and left in build/results/NAME, below five
# lines: TITLE, the command as it was typed, the status, when it began, and how many seconds it took.
# COMMAND is for scripts/report: what one types to have it. What runs below another one that is
# recorded belongs to that.
record() {
  [[ ! ${COSIM_RECORDED-} ]] || return 0
  local results=$root/build/results began=$EPOCHSECONDS status
  mkdir -p "$results"
  local recorded=$results/.$1
  rm -f "$recorded" "$recorded.new" # of one that was stopped
  set +e
  # Where this one is ended that one is too.
  COSIM_RECORDED=$1 setpriv --pdeathsig TERM -- "$0" "${arguments[@]}" | tee "$recorded"
  status=${PIPESTATUS[0]}
  set -e
  {
    printf '%s\n' "$2" "scripts/$(basename "$0")${arguments[*]:+ ${arguments[*]}}" "$status" \
      "$began" $((EPOCHSECONDS - began))
    cat "$recorded"
  } > "$recorded.new"
  mv "$recorded.new" "$results/$1"
  rm "$recorded"
  exit "$status"
}
