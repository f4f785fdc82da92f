#!/usr/bin/env bash
# hostile_names_test.sh SOURCES PROGRAM
#
# A name that holds commands of yosys, gnuplot or a shell is taken for that name, or refused, wherever a
# script or CMake gives it to one of them; nothing in it is run. SOURCES: the project's folder; PROGRAM: cosim_rtl.
# Status: 0 so, 1 not, 77 where yosys is not installed.
# shellcheck disable=SC2016  # what is in the names is to be run by nobody
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs yosys
sources=$(realpath "$1") rtl=$(realpath "$2")
cd "$folder"
read -ra shape < <(grep -m1 '^[^#]' "$sources/rtl/shipped.txt")

for name in 'a; exec -- touch pwned; log .v' 'a"; exec -- touch pwned; log ".v' 'a b.v'; do
  "$sources/scripts/netlist" --write "$name" generic "${shape[@]}" > said 2>&1 ||
    { cat said && exit 1; }
  grep -q "^module ${shape[0]}\b" "$name" || { echo "$name: no netlist" && exit 1; }
done
refused() {
  local status=0 said=$1
  shift
  "$@" > out 2> said || status=$?
  if ((status == 0)) || ! grep -qF -- "$said" said; then
    cat out said && echo "not so: $* is refused" && exit 1
  fi
}

# A line of shipped.txt goes to the linters.
mkdir rtl
for line in 'lin; exec -- touch pwned' 'lin W=$(touch${IFS}pwned)' 'lin W=4; exec -- touch pwned'; do
  echo "$line" > rtl/shipped.txt
  refused "no design and its parameters: $line" "$sources/scripts/lint" --rtl rtl
done

# A folder for temporary files; the picture that is drawn.
mkdir -p tree/scripts $'tmp"; system "touch pwned'
cp "$sources"/scripts/{picture,lib.sh} tree/scripts
printf '#!/bin/sh\nprintf "block,a,b,x,y\\n0,0,0,1,2\\n0,0,0,3,4\\n" > "$6"\n' > tree/scripts/cosim
chmod +x tree/scripts/cosim
if command -v gnuplot > /dev/null; then
  for name in $'p"; system "touch pwned' 'a b;!touch pwned' $'it\'s.png'; do
    COSIM_RECORDED=yes TMPDIR=$PWD/$'tmp"; system "touch pwned' \
      tree/scripts/picture in.ngc 10 "$name" > said 2>&1 || { cat said && exit 1; }
    [[ -s $name ]] || { echo "$name: no picture" && exit 1; }
  done
fi

# What CMake has of a design.
for word in 'top; exec -- touch pwned' $'A="x' $'A\nexec' '#'; do
  cat > words.cmake << END
include($sources/tb/dut/rtl.cmake)
cosim_words_for_tools(here [==[$word]==])
END
  refused "yosys cannot be given the name" cmake -P words.cmake
done
for words in 'my-fifo' 'fifo STRUCT "acme::;int"'; do
  printf '%s\n' 'set(VERILATOR_ROOT x)' "include($sources/tb/package/design.cmake)" \
    "cosim_add_design($words SOURCES none.v MODEL none.h)" > add.cmake
  refused "names" cmake -P add.cmake
done
mkdir 'of a design'
echo 'module loop(input d, output q); wire a; assign a = q ^ d; assign q = a & d; endmodule' > 'of a design/loop.v'
cat > loop.cmake << END
include($sources/tb/dut/rtl.cmake)
set_property(GLOBAL PROPERTY COSIM_RTL_PROGRAM $rtl)
find_program(VERILATOR_BIN verilator)
cosim_read_rtl(r made loop - "$PWD/of a design/work" FILES "$PWD/of a design/loop.v")
END
refused "a combinational loop" cmake -P loop.cmake
[[ ! -e pwned ]] || { echo "the name of a file was run" && exit 1; }
echo "taken for names, or refused"
