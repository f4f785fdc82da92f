# shellcheck shell=bash
# shellcheck disable=SC2154 # clang, tree and scratch are set by scripts/lint
# What scripts/lint has Clang compile: the units of the build folder `clang` that are, or as unity files
# hold, files of the project in `tree`.

# build_of_clang: configures that of the repository, and makes the headers of Verilated classes that a
# file of the project names itself.
build_of_clang() {
  local names headers
  build clang ''
  names=$(cd "$tree" && grep -rhoE '^#include "V[A-Za-z0-9_]+_ports\.h"' tb tests --include='*.cpp' |
    sed 's/.*"\(.*\)"/\1/' | sort -u)
  mapfile -t headers < <(ninja -C "$clang" -t targets all | sed -n 's/: CUSTOM_COMMAND$//p' |
    grep -v '^/' | grep -F -- "$names")
  compile "the headers of RTL" "$clang" ninja -C "$clang" "${headers[@]}"
}

# clang_commands: what checks the syntax of each unit, a line each, with the unit behind the last space.
clang_commands() {
  sed -n 's/^ *"command": "\(.*\)",\{0,1\}$/\1/p' "$clang/compile_commands.json" |
    sed 's/\\\(["\\]\)/\1/g; s/ -o [^ ]* -c / -fsyntax-only /'
}

# files_of UNIT: the files of the project in it.
files_of() {
  if [[ $1 == */Unity/* ]]; then sed -n 's/^#include "\(.*\)"$/\1/p' "$1"; else echo "$1"; fi |
    grep "^$tree/.*\.cpp$" | grep -v "^$clang/"
}

# clang_units: those of the commands, a line each, that have files which no unit before them has; all
# the files are left in scratch/files.
clang_units() {
  local unit
  : > "$scratch/files"
  while read -r unit; do
    files_of "$unit" | grep -vxFf "$scratch/files" > "$scratch/more" || continue
    cat "$scratch/more" >> "$scratch/files"
    echo "$unit"
  done < <(sed 's/.* //' "$scratch/commands")
}

# Says of a unit what is wrong in it, a line each, and for what is wrong in a header of a library which
# line of the project led there.
lint_clang() {
  local said=$scratch/clang.$BASHPID status=0
  eval "$(grep -m 1 " $1$" "$scratch/commands")" > "$said" 2>&1 || status=$?
  sed "s:^$tree/::" "$said" | cut -c 1-300 |
    grep -E '^[^ ]+: (fatal error|error|warning): |^[^/ ]+: note: in instantiation ' ||
    { ((!status)) || cat "$said"; }
}
