#!/usr/bin/env bash
# new_types_test.sh PROGRAM BUILD
#
# `cosim new` of SystemVerilog that the command lines of tools cannot describe: parameters of type and of a
# struct, a file of macros, checks that wait, and what Verilator refuses. Status: 0 so, 1 not, 77 without yosys.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs yosys
program=$1 build=$(realpath "$2")
cd "$folder"
cat > bus_pkg.sv << 'RTL'
package bus_pkg;
  typedef struct packed { logic [6:0] a; logic b; } req_t;
  typedef struct packed { int unsigned width; logic sets; } config_t;
  localparam config_t WIDE = '{width: 5, sets: 1'b1};
endpackage
RTL
cat > cut.sv << 'RTL'
module cut #(
  parameter type req_t = logic, // of the bus
  parameter int unsigned N = 2
) (
  input logic clk,
  input req_t d,
  output logic [N-1:0] q, output req_t kept
);
  always_ff @(posedge clk) begin
    kept <= d;
    q <= N'(d.a);
  end
endmodule
RTL
cat > sized.sv << 'RTL'
module sized import bus_pkg::*; #(parameter config_t P, localparam int W = P.width)
  (input logic clk, input logic [W-1:0] d, output logic [W-1:0] q);
  always_ff @(posedge clk) q <= P.sets ? d : '0;
endmodule
RTL

# says LINE: so it was said.
says() { grep -qxF -- "$1" said || { cat said && echo "it did not say: $1" && exit 1; }; }
refused() {
  local status=0
  rm -rf made
  "$program" new made "$@" > said 2>&1 || status=$?
  [[ $status == 2 && ! -e made ]] || { cat said && echo "status $status of: $*" && exit 1; }
}
made() {
  rm -rf made
  "$program" new made "$@" > said 2>&1 || { cat said && exit 1; }
}

refused cut.sv
says "cosim: new: cut.sv:11: d has no members: its type may be a parameter of the top: cosim new --param TYPE=PACKAGE::STRUCT"
made bus_pkg.sv cut.sv --param req_t=bus_pkg::req_t --param N=3
grep -qx '  cut #(.N(N), .req_t(req_t)) dut (.\*);' made/made_top.sv
grep -qF 'At<"d[7:1]", UInt<7>> a;' made/made.h
grep -qx '    UInt<N> q;' made/made.h
grep -qF 'At<"dut.kept[0]", Bit>> b;' made/made.h
grep -q 'SOURCES bus_pkg.sv cut.sv made_top.sv TOP made_top .* SHAPES "N=3"' made/CMakeLists.txt
# A type that is written out; a name that matches a word is a type where the head says so.
made cut.sv --param 'req_t=struct packed { logic [2:0] a; }'
grep -qx '    UInt<3> d;' made/made.h
mkdir lib && cp bus_pkg.sv sized.sv lib
refused lib --top sized
says "cosim: new: the parameter P has no value of its own: give it one: cosim new --param P=VALUE, in CMake SHAPES \"P=VALUE\""
made lib --top sized --param P=bus_pkg::WIDE
grep -qx '    UInt<5> d;' made/made.h
refused lib --top sized --param Q=bus_pkg::WIDE
says "cosim: --param: sized has no parameter Q"

# A head without types of its ports has parameters of numbers all the same.
printf 'module old(clk, d, q);\nparameter W = 2;\ninput clk;\ninput [W-1:0] d;\noutput reg [W-1:0] q;\n' > old.v
printf 'always @(posedge clk) q <= d;\nendmodule\n' >> old.v
made old.v --param W=3
refused old.v --param W=bus_pkg::WIDE
says "cosim: old: the list of its ports has no types: no wrapper can be written"

# Macros of a file without modules are for those before it, too.
cat > defs.vh << 'RTL'
`define WIDE [3:0]
RTL
cat > aa.sv << 'RTL'
module aa(input clk, input `WIDE d, output reg `WIDE q); always @(posedge clk) q <= d; endmodule
RTL
made aa.sv defs.vh
grep -qx '    UInt<4> d;' made/made.h

# What is missing is named.
cat > head.v << 'RTL'
`include "none.vh"
module head(input clk, output reg q); always @(posedge clk) q <= 1; endmodule
RTL
refused head.v
says "cosim: new: head.v:1: no folder has the header none.vh: cosim new --include DIR, in CMake INCLUDE_DIRS DIR"
printf 'module pack import no_pkg::*; (input clk, output reg q);\nalways @(posedge clk) q <= 1;\nendmodule\n' > pack.sv
refused pack.sv
says "cosim: new: pack.sv:1: no file has the package no_pkg: give its file, too"
refused aa.sv
says "cosim: new: aa.sv:1: no file defines the macro WIDE: give the file that does, or cosim new --define WIDE, in CMake DEFINES WIDE"

# A check that waits is left out with SYNTHESIS.
cat > waits.sv << 'RTL'
module waits(input logic clk, d, output logic q);
  always_ff @(posedge clk) q <= d;
`ifndef SYNTHESIS
  always @(d) #0 begin if (d === 1'bx) $display("x"); end
`endif
endmodule
RTL
made waits.sv
says "made: SYNTHESIS is defined; without it: waits.sv:4: waits, as a testbench does and no circuit. Only the delay of an assignment (q <= #1 d) is left out"
grep -q ' DEFINES SYNTHESIS ' made/CMakeLists.txt

# What Verilator refuses may be read by slang.
cat > both.sv << 'RTL'
module both(input logic clk, input logic [1:0] d, output logic [1:0] q);
  always_comb q[0] = d[0];
  always_ff @(posedge clk) q[1] <= d[1];
endmodule
RTL
if [[ -e ${COSIM_SLANG:-$build/systemverilog/installed.json} ]]; then
  made both.sv
  grep -q '^made: both_slang.v replaces the sources, as slang reads them with these parameters: Verilator cannot lint it: ' said
  grep -q 'SOURCES both_slang.v ' made/CMakeLists.txt
  [[ ! -e made/both.sv ]]
else
  refused both.sv
fi
