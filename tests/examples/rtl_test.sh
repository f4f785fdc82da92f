#!/usr/bin/env bash
# rtl_test.sh SOURCES PROGRAM
#
# What cosim_add_design() reads out of RTL when CMake configures: registers, with the nets that carry
# them, and asynchronous resets; and what it refuses, in one line that names the net. SOURCES is the
# project's folder, PROGRAM is cosim_rtl. Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
sources=$1
cd "$folder"
cat > read.cmake << END
include($sources/tb/dut/rtl.cmake)
set_property(GLOBAL PROPERTY COSIM_RTL_PROGRAM $2)
include($sources/tb/dut/shape.cmake)
find_program(VERILATOR_BIN verilator)
if(SHAPE)
  cosim_shape(s shape "\${SHAPE}")
  message("\${s_title}|\${s_values}|\${s_generics}|\${s_constants}")
else()
  if(NOT CLOCKS)
    set(CLOCKS clk)
  endif()
  cosim_read_rtl(r made made \${CLOCKS} $folder/work FILES $folder/made.sv)
  if(CLOCKS MATCHES ",")
    string(APPEND r_resets "|\${r_clocks}")
  endif()
  message("\${r_registers}|\${r_resets}")
endif()
END

options=()
# rtl BODY: a module with a clock, some inputs and outputs.
rtl() {
  printf 'module made(input wire clk, other, d, input wire [7:0] w, output reg q, r);\n%s\nendmodule\n' \
    "$1" > made.sv
}
fails() {
  printf 'not so: %s; it said\n%s\n' "$1" "$said"
  exit 1
}
# refused LINE: that is the error.
refused() {
  ! said=$(cmake "${options[@]}" -P read.cmake 2>&1) || fails "'$1' ends it"
  [[ $(grep -c . <<< "$said") -ge 1 && $said == *"$1"* ]] || fails "it is refused: $1"
}
# found TEXT: that was read.
found() {
  said=$(cmake "${options[@]}" -P read.cmake 2>&1) || fails "it is read"
  [[ $said == "$1" ]] || fails "it finds $1"
}

rtl 'always @(posedge clk) q <= d; always @(posedge other) r <= d;'
refused "made: r: its clock is other, and that of the design is clk"
rtl 'wire gated = clk & d; always @(posedge gated) q <= d;'
refused "made: q: its clock is gated, which is no input"
# A delay of an assignment is left out, as by a synthesizer; what waits is no circuit.
rtl 'always @(posedge clk) q <= #1 d; assign #2 r = q;'
found 'q 1 0 0:0 r 1 0 0|'
rtl 'always @(posedge clk) begin #1 q <= d; end'
refused "made: made.sv:2: waits, as a testbench does and no circuit"
rtl 'initial forever @(posedge clk) q = d;'
refused "made: made.sv:2: waits, as a testbench does"
rtl 'always @(posedge clk) begin if (other) begin /* verilator lint_off STMTDLY */ #5; r <= w[0]; end q <= d; end'
found 'q 1 0 0:0\nr 1 0 0:0|'
# More words than Verilator unrolls by itself.
rtl 'reg [7:0] m [0:199]; integer i; always @(posedge clk) if (other) for (i = 0; i < 200; i = i + 1) m[i] <= w;
     else r <= m[w][0];'
found 'm 8 200 1599:0\nr 1 0 0:0|'
# yosys makes a latch of it that is always open.
rtl 'reg [0:0] u; reg [1:0] e [0:1]; integer i, j, o;
     always @(*) begin
       o = 0;
       for (i = 0; i < 2; i = i + 1) begin
         e[i][i] = 1;
         for (j = i + 1; j < 2; j = j + 1) e[i][j] = d;
         for (j = 0; j < i; j = j + 1) e[i][j] = !e[j][i];
         o = o + 1 - i;
       end
       o = 0;
       for (i = 0; i < 2; i = i + 1) begin
         for (j = i + 1; j < 2; j = j + 1) u[o + j - i - 1] = e[i][j];
         o = o + 1 - i;
       end
     end
     always @(posedge clk) q <= u;'
found 'q 1 0 0:0|'
# A gate or a divider that is an instance is named.
printf 'module icg(input wire clk, en, output wire gclk); reg held;
  always @* if (!clk) held = en; assign gclk = clk & held; endmodule
module made(input wire clk, en, d, output reg q);
  wire g; icg gate(.clk(clk), .en(en), .gclk(g)); always @(posedge g) q <= d; endmodule\n' > made.sv
refused "made: q: its clock is g, made by gate.gclk, which is no input"
printf 'module half(input wire clk, output reg by2); always @(posedge clk) by2 <= !by2; endmodule
module made(input wire clk, d, output reg q);
  wire slow; half divider(.clk(clk), .by2(slow)); always @(posedge slow) q <= d; endmodule\n' > made.sv
refused "made: q: its clock is slow, made by divider.by2, which is no input"
rtl 'always @(negedge clk) q <= d;'
refused "made: q: a register on the falling edge of clk"
rtl 'always @* if (other) q = d; always @(posedge clk) r <= q;'
refused "made: q: a latch"
rtl 'always_latch if (other) q = d; always @(posedge clk) r <= q;'
refused "made: q: a latch"
printf 'module made(input wire clk, inout wire both, output reg q);
always @(posedge clk) q <= both; endmodule\n' > made.sv
refused "made: both: a port of both directions"
printf 'module made(input wire ck, output reg q); always @(posedge ck) q <= !q; endmodule\n' > made.sv
refused "made: clk: the RTL has no such input, but it is named as its clock"
rtl 'always @(posedge clk or posedge d or negedge other) if (d) q <= 0; else if (!other) q <= 1; else q <= w[0];'
refused "made: q: an asynchronous set and reset, d and other"
rtl 'wire x = d & other; always @(posedge clk or posedge x) if (x) q <= 0; else q <= w[0];'
refused "made: q: an asynchronous reset by x, which is no input"
rtl 'reg n; always @(posedge clk) n <= d; always @(posedge clk or negedge n) if (!n) q <= 0; else q <= w[0];'
found 'n 1 0 0:0\nq 1 0 0:0|inner low n'
rtl 'reg n; always @(posedge clk) n <= d; wire up = !n;
     always @(posedge clk or posedge up) if (up) q <= 0; else q <= w[0];
     always @(posedge clk or posedge other) if (other) r <= 0; else r <= w[1];'
found 'n 1 0 0:0\nq 1 0 0:0\nr 1 0 0:0|other\ninner low n'
rtl 'always @(posedge clk) q <= d'
refused "made: Verilator cannot read it: %Error: "
printf 'module made #(parameter N)(input wire clk, d, output reg q); always @(posedge clk) q <= d ^ N;
endmodule\n' > made.sv
refused "made: the parameter N has no value of its own"
if command -v yosys > /dev/null; then
  rtl 'wire y, z; assign y = z ^ d; assign z = y & w[0]; always @(posedge clk) q <= y;'
  refused "made: y: a combinational loop"
  # Within a cell of several bits, and of whole nets alone.
  rtl 'wire [1:0] y; assign y = {y[0], y[1]} ^ w[1:0]; always @(posedge clk) q <= y[0];'
  refused "made: y: a combinational loop"
  rtl 'wire [1:0] y; assign y = {y[0], d} ^ w[1:0]; always @(posedge clk) q <= y[1];'
  found 'q 1 0 0:0|'
  # Beside a carry chain, which Verilator takes for one as well; and of nets with names like those that
  # yosys gives.
  rtl 'wire [3:0] a; assign a[0] = d; assign a[3:1] = a[2:0] & w[3:1];
       wire y, z; assign y = z ^ a[3]; assign z = y & w[0]; always @(posedge clk) q <= y;'
  refused "made: y: a combinational loop"
  rtl 'wire y$, z$; assign y$ = z$ ^ d; assign z$ = y$ & w[0]; always @(posedge clk) q <= y$;'
  refused ": a combinational loop"
  # What yosys finds beside Verilator: a loop that writes at an index that is not its own, and a latch of
  # some bits. What no output depends on is no state because yosys has a flip-flop for it.
  rtl 'reg [3:0] held, some; integer i;
       always @(posedge clk) begin for (i = 0; i < 2; i = i + 1) held[w[1:0]] = d;
         if (other) begin some = w[3:0]; r <= ^some; end
         q <= ^held; end'
  found 'held 4 0 3:0\nq 1 0 0:0\nr 1 0 0:0|'
  rtl 'reg [3:0] store[1:2]; reg [3:0] sum; integer i;
       always @(posedge clk) begin for (i = 0; i < 2; i = i + 1) store[1 + w[0]] = w[3:0];
         sum = store[1] ^ store[2]; q <= ^sum; end'
  found 'q 1 0 0:0\nstore 4 2 7:0|'
  rtl 'reg [1:0] l; always @* begin l[0] = d; if (other) l[1] = d; end always @(posedge clk) q <= ^l;'
  refused "made: l: a latch"
else
  echo "no yosys: no loop is looked for, and nothing found beside Verilator"
fi

# A carry chain is no loop. What a clock only works with is no register; a word of an array, a part of a
# net, one written by a task is. Nets that carry it are known through instances.
cat > made.sv << 'RTL'
module part(input wire c, input wire in, output wire out);
  reg held; assign out = held; always @(posedge c) held <= in;
endmodule
module made(input wire clk, rst_n, input wire [3:0] d, output wire [3:0] q, output reg last);
  wire ck; assign ck = clk;
  wire [3:0] carry; assign carry[0] = d[0];
  assign carry[3:1] = carry[2:0] & d[3:1];
  wire top; part one(.c(ck), .in(carry[3]), .out(top));
  genvar g; generate for (g = 0; g < 2; g = g + 1) begin : both
    reg bit_of; always @(posedge clk) bit_of <= d[g];
  end endgenerate
  reg [3:0] store[0:3], sum, kept; reg [3:0] next; integer i;
  always @(posedge clk) begin
    next = d; store[d[1:0]] <= next;
    for (i = 0; i < 4; i = i + 1) sum[i] <= next[i] ^ both[0].bit_of;
  end
  task keep(input [3:0] v); kept <= v; endtask
  always @(posedge ck or negedge rst_n) if (!rst_n) last <= 0; else begin last <= d[1]; keep(d); end
  reg [1:0] count; always @(posedge clk) count = count + 1;
  assign q = sum ^ store[0] ^ kept ^ {2'b0, count} ^ {3'b0, both[1].bit_of ^ top};
endmodule
RTL
found 'both[0].bit_of 1 0 0:0\nboth[1].bit_of 1 0 0:0\ncount 2 0 1:0\nkept 4 0 3:0\nlast 1 0 0:0\none.held 1 0 0:0 one.out 1 0 0 top 1 0 0\nstore 4 4 15:0\nsum 4 0 3:0|low rst_n'

# [N-1:0] of an unsigned N of 0 is [-1:0], not two to the 32nd.
printf 'module made #(parameter int unsigned N = 0)(input wire clk, input wire [N-1:0][3:0] d,
output reg [N-1:0][3:0] q); always_ff @(posedge clk) q <= d; endmodule\n' > made.sv
(ulimit -v 2000000 && found 'q 8 0 7:0|')

# Several clocks, each on one edge; and one that is to be an input of the model.
options=('-DCLOCKS=clk,other,')
rtl 'always @(posedge clk) q <= d; always @(posedge other) r <= d;'
found 'q 1 0 0:0\nr 1 0 0:0||clk\nother'
rtl 'always @(posedge clk or posedge d) if (d) q <= 0; else q <= w[0]; always @(negedge other) r <= d;'
found 'q 1 0 0:0\nr 1 0 0:0|d|clk\nfalling other'
rtl 'always @(posedge clk) q <= d; always @(negedge clk) r <= d;'
refused "made: r and q: registers on both edges of clk"
rtl 'reg div; always @(posedge clk) div <= !div; always @(posedge div) q <= d; always @(posedge other) r <= d;'
refused "made: q: its clock is div, which is no input"
rtl 'always @(posedge d) q <= w[0]; always @(posedge other) r <= d;'
refused "made: q: its clock is d, and those of the design are clk and other"
rtl 'always @(posedge clk) q <= other; always @(posedge other) r <= d;'
refused "made: other: a clock that is read as a value"
printf 'module made(input wire clk, other, output wire c, output reg q); assign c = other;
always @(posedge clk) q <= !q; endmodule\n' > made.sv
refused "made: c: an output that is the clock other"
options=('-DCLOCKS=clk,')
rtl 'always @(negedge clk) q <= d;'
found 'q 1 0 0:0||falling clk'
options=()

# A reset behind inverters is that of the input.
cat > made.sv << 'RTL'
module part(input wire clk, r, d, output reg q); always @(posedge clk or posedge r) if (r) q <= 0; else q <= d;
endmodule
module made(input wire clk, rst_n, d, output wire q, output reg r, s);
  part one(.clk(clk), .r(!rst_n), .d(d), .q(q));
  wire rst = ~rst_n, again = !rst;
  always @(posedge clk or posedge rst) if (rst) r <= 0; else r <= d;
  always @(posedge clk or negedge again) if (!again) s <= 0; else s <= d;
endmodule
RTL
found 'one.q 1 0 0:0 q 1 0 0\nr 1 0 0:0\ns 1 0 0:0|low rst_n'

# A memory of several dimensions has all elements as its words.
rtl 'reg [3:0] one[0:3], two[0:1][1:3]; reg [1:0][3:0] net, of_nets[0:1];
     always @(posedge clk) begin one[w[1:0]] <= w[3:0]; two[d][w[1:0]] <= w[3:0]; net <= w;
       of_nets[d] <= w; q <= ^{one[0], two[0][1], net, of_nets[0]}; end'
found 'net 8 0 7:0\nof_nets 8 2 15:0\none 4 4 15:0\nq 1 0 0:0\ntwo 4 6 23:0|'

# Registers in every kind of place. A variable that each way through a process writes before it reads it
# is none; one that only some ways write is.
cat > made.sv << 'RTL'
interface bus(input logic c); logic [3:0] held; logic [7:0] own; modport m(output held, input c);
  always_ff @(posedge c) own[3:0] <= held; endinterface
package pk; logic [3:0] seen; function automatic [3:0] half(input [3:0] v);
  logic [3:0] t; t = v >> 1; return t; endfunction endpackage
module part(bus.m b, input logic d); always_ff @(posedge b.c) b.held <= {3'b0, d}; endmodule
module made(input wire clk, input wire [1:0] s, input wire [3:0] d, output reg [3:0] q);
  bus port(.c(clk)); part one(.b(port), .d(d[0]));
  typedef struct packed {logic [2:0] x; logic y;} pair;
  pair both; reg [3:0] memory[1:3]; reg [7:4] high; reg [0:3] up; reg [3:0] sum, some, each, way, next;
  always @(posedge clk) begin : named
    reg [3:0] dead; integer i;
    dead <= d; both.x <= d[2:0]; memory[2] <= d; memory[3][1:0] <= d[1:0]; high[5] <= d[0]; up[0] <= d[0];
    pk::seen <= d;
    for (i = 0; i < 4; i = i + 1) sum[i] = d[i];
    if (d[0]) some = d;
    if (d[1]) each = d; else each = 4'd1;
    case (s) 0: way = d; 1, 2: way = 4'd2; default: way = 4'd3; endcase
    case (s) 0, 1: next = d; 2: next = 4'd2; 3: next = 4'd3; endcase
    if (s == 2) begin : deep reg [1:0] kept; kept = kept + 1; end
    q <= sum ^ some ^ each ^ way ^ next ^ pk::half(d);
  end
endmodule
RTL
found 'both 4 0 3:1\nhigh 4 0 1:1\nmemory 4 3 9:4\nnamed.dead 4 0 3:0\nnamed.deep.kept 2 0 1:0\npk.seen 4 0 3:0\nport.held 4 0 3:0\nport.own 8 0 3:0\nq 4 0 3:0\nsome 4 0 3:0\nup 4 0 3:3|'

# A latch is found where the RTL turns its warning off, too, and without yosys.
options=(-DCOSIM_YOSYS=)
rtl 'reg l; /* verilator lint_off LATCH */ always @* if (other) l = d;
     /* verilator lint_on LATCH */ always @(posedge clk) q <= l;'
refused "made: l: a latch"
rtl '`define HELD always_latch
     `HELD if (other) r = d; always @(posedge clk) q <= r;'
refused "made: r: a latch"
options=()

# Without what Verilator says of the RTL nothing goes on.
cat > verilator_new << 'END'
#!/bin/sh
echo "%Error: Invalid option: --json-only"
exit 1
END
chmod +x verilator_new
! said=$(cmake -DVERILATOR_BIN="$folder/verilator_new" -P read.cmake 2>&1) || fails "it needs the tree"
[[ $said == *"made: Verilator cannot read it: %Error: Invalid option: --json-only"* ]] || fails "it says what is missing"

# A shape, for Verilator, yosys and C++.
said=$(cmake "-DSHAPE=W=8 MASK=8'h1F K=4'b1_01 MODE=FAST" -P read.cmake 2>&1)
[[ $said == "W=8 MASK=31 K=5 MODE=FAST|8, 31, 5, \"FAST\"|-GW=8;-GMASK=8'h1F;-GK=4'b1_01;-GMODE=\"FAST\"|\
{\"MASK\", \"8'h1F\"}, {\"K\", \"4'b1_01\"}, {\"MODE\", \"32'h46415354\"}" ]] || fails "the shape is read"
for wrong in "W" "W=4'b12" "W=40'hFFFFFFFFFF" 'W=a"b'; do
  ! said=$(cmake "-DSHAPE=$wrong" -P read.cmake 2>&1) || fails "$wrong is refused"
  [[ $said == *"shape: SHAPES: "* ]] || fails "$wrong is named"
done
echo "read or refused"
