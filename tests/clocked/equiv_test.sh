#!/usr/bin/env bash
# equiv_test.sh COSIM TO_VERILOG EXPORTED ROOT: the golden model of examples/uart as it was exported, proved
# equal to its RTL, and told apart from RTL in which something is changed.
set -euo pipefail
cosim=$1 to_verilog=$2 exported=$3 rtl=$4/examples/uart
command -v yosys > /dev/null || { echo 'needs yosys' && exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# equal STATUS D FILE: whether `equiv` of the model and the RTL with uart.v in FILE ends with STATUS.
equal() {
  local status=0
  "$to_verilog" uart clock "$exported/uart_$2.btor2" > model.v
  "$cosim" equiv --gold model.v --gate "$3" "$rtl/uart_divider.v" --gate-param "D=$2" --top uart \
    --failures failures > log 2>&1 || status=$?
  [[ $status == "$1" ]] || { cat log && echo "$3, D=$2: status $status in place of $1" && exit 1; }
}

equal 0 4 "$rtl/uart.v"
equal 0 16 "$rtl/uart.v"
sed "s/left  <= 4'd10/left  <= 4'd11/" "$rtl/uart.v" > changed.v
if cmp -s changed.v "$rtl/uart.v"; then echo "nothing is changed" && exit 1; fi
equal 1 4 changed.v
