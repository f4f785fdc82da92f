#!/usr/bin/env bash
# registers_test.sh SOURCES PROGRAM [DRAWS [SEED]]
#
# Draws RTL with registers in all kinds of places, and variables that are none among them, and looks
# that cosim_read_rtl() finds exactly the bits that hold a state. SOURCES is the project's folder, PROGRAM is
# cosim_rtl.
# Status: 0 so, 1 not; then the RTL is printed.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
sources=$1 draws=${3:-6} RANDOM=${4:-1}
cd "$folder"
cat > read.cmake << END
include($sources/tb/dut/rtl.cmake)
set_property(GLOBAL PROPERTY COSIM_RTL_PROGRAM $2)
find_program(VERILATOR_BIN verilator)
set(COSIM_YOSYS "")
cosim_read_rtl(r made made clk $folder/work FILES $folder/made.sv)
message("\${r_registers}")
END

# below N: sets `drawn`. Not in a subshell, whose RANDOM is its own.
below() { drawn=$((RANDOM % $1)); }
outside='' inside='' expected=()
# state NAME WIDTH WORDS BITS: a register that is to be found.
state() { expected+=("$1 $2 $3 $4"); }
# place NAME KIND: one register, or what looks like one, in a place of its own.
place() {
  local n=$1 clocked='always @(posedge clk)' w last high low word
  below 7 && w=$((2 + drawn)) && last=$((w - 1))
  below "$w" && high=$drawn
  below $((high + 1)) && low=$drawn
  below 3 && word=$drawn
  local part="[$high:$low] <= d[$high:$low];" bits="$high:$low"
  case $2 in
    0) inside+="reg [$last:0] $n; $clocked $n <= d;" && state "$n" $w 0 "$last:0" ;;
    1) inside+="reg [$last:0] $n; $clocked $n$part" && state "$n" $w 0 $bits ;;
    2) inside+="reg [$last:0] $n; $clocked if (s[0]) $n$part" && state "$n" $w 0 $bits ;;
    3) inside+="$clocked begin : b_$n reg [$last:0] r; r$part end" && state "b_$n.r" $w 0 $bits ;;
    4) inside+="generate if (1) begin : g_$n reg [$last:0] r; $clocked r$part end endgenerate" &&
      state "g_$n.r" $w 0 $bits ;;
    5) inside+="for (genvar i = 0; i < 2; ++i) begin : g_$n reg [$last:0] r; $clocked r$part end" &&
      state "g_${n}[0].r" $w 0 $bits && state "g_${n}[1].r" $w 0 $bits ;;
    6) outside+="module m_$n(input clk, input [7:0] d); reg [$last:0] r; $clocked r$part endmodule " &&
      inside+="m_$n i_$n(clk, d);" && state "i_$n.r" $w 0 $bits ;;
    7) inside+="reg [$last:0] ${n}[0:2]; $clocked ${n}[s] <= d;" && state "$n" $w 3 "$((3 * w - 1)):0" ;;
    8) inside+="reg [$last:0] ${n}[2:0]; $clocked ${n}[$word]$part" &&
      state "$n" $w 3 "$((word * w + high)):$((word * w + low))" ;;
    9) inside+="struct packed {logic a; logic [$last:0] b; logic [1:0] c;} $n; $clocked $n.b$part" &&
      state "$n" $((w + 3)) 0 "$((high + 2)):$((low + 2))" ;;
    10) outside+="interface f_$n(input logic clk); logic [$last:0] r; modport m(output r, input clk);
        endinterface module m_$n(f_$n.m f, input [7:0] d); always @(posedge f.clk) f.r$part endmodule " &&
      inside+="f_$n i_$n(clk); m_$n j_$n(i_$n, d);" && state "i_$n.r" $w 0 $bits ;;
    11) outside+="interface f_$n(input logic clk, input [7:0] d); logic [$last:0] r; $clocked r$part
        endinterface " && inside+="f_$n i_$n(clk, d);" && state "i_$n.r" $w 0 $bits ;;
    12) outside+="package p_$n; logic [$last:0] v_$n; endpackage " &&
      inside+="$clocked p_$n::v_$n$part" && state "p_$n.v_$n" $w 0 $bits ;;
    13) inside+="reg [$last:0] $n; task t_$n; $n$part endtask $clocked t_$n;" &&
      state "$n" $w 0 $bits ;;
    14) inside+="reg [$last:0] $n; $clocked $n = $n + 1;" && state "$n" $w 0 "$last:0" ;;
    15) inside+="reg [$last:0] $n, r_$n; $clocked begin if (s[0]) $n = d; r_$n <= $n; end" &&
      state "$n" $w 0 "$last:0" && state "r_$n" $w 0 "$last:0" ;;
    16) inside+="reg [0:$last] $n; $clocked ${n}[$((last - high)):$((last - low))] <= d[$high:$low];" &&
      state "$n" $w 0 $bits ;;
    17) inside+="reg [$last:0] $n, r_$n; always @* if (s[0]) $n = d; else $n = ~d;
        $clocked begin : b_$n integer i; for (i = 0; i < $w; i = i + 1) r_${n}[i] <= ${n}[i]; end" &&
      state "r_$n" $w 0 "$last:0" ;;
    18) inside+="reg [$last:0] $n, r_$n; $clocked begin if (s[0]) $n = d; else $n = 1;
        case (s) 0, 3: $n = $n + 1; default: ${n}[0] = 0; endcase r_$n <= $n; end" &&
      state "r_$n" $w 0 "$last:0" ;;
  esac
  inside+=$'\n'
}

# Each kind of place at least once, then some more of any.
for ((draw = 0; draw < draws; ++draw)); do
  outside='' inside='' expected=()
  for ((i = 0; i < 25; ++i)); do
    below 19
    place "n$i" $((i < 19 ? i : drawn))
  done
  printf '%s\nmodule made(input clk, input [7:0] d, input [1:0] s, output o);\n%sassign o = d[0];\nendmodule\n' \
    "$outside" "$inside" > made.sv
  cmake -P read.cmake > said 2>&1 || { cat made.sv said && exit 1; }
  sed 's/\\n/\n/g' said | cut -d' ' -f1-4 | sort > found
  printf '%s\n' "${expected[@]}" | sort > expected
  diff expected found || { echo "draw $draw: < is expected, > is found" && cat made.sv && exit 1; }
done
echo "$draws modules: every bit that holds a state is found, and no other"
