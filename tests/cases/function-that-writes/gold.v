// A function that writes a register, called alone; one with variables of its own; a memory that only
// initial writes, read by a function in assign; a task that counts.
module t(input clk, rst, input [3:0] a, b, output reg [3:0] q, r, output [3:0] y, z);
  reg [3:0] last, rom[0:15];
  integer i;
  initial for (i = 0; i < 16; i = i + 1) rom[i] = 15 - i;
  function [3:0] kept(input [3:0] v);
    reg [3:0] more;
    begin
      more = v + 1;
      last = more;
      kept = ~v;
    end
  endfunction
  function [3:0] low(input [3:0] v);
    reg [3:0] last;
    begin
      last = v & 4'h3;
      low = last;
    end
  endfunction
  function [3:0] word(input [3:0] at);
    word = rom[at];
  endfunction
  task counted;
    r <= r + 1;
  endtask
  assign y = a == 3 || low(b) == 2 ? low(a) : 4'd9, z = word(b);
  always @(posedge clk)
    if (rst) begin
      last = 0;
      q <= 0;
      r <= 0;
    end else begin
      q <= last;
      if (a == b) q <= kept(a);
      if (b[0] && !a[0]) counted;
    end
endmodule
