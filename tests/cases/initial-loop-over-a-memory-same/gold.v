// An initial loop fills a memory.
module t(input [2:0] a, output [5:0] q);
  reg [5:0] m [0:7];
  integer i;
  initial for (i = 0; i < 8; i = i + 1) m[i] = i * i;
  assign q = m[a];
endmodule
