// A range of $readmemh that descends.
module t(input [1:0] a, output [3:0] q);
  reg [3:0] m [0:3];
  initial $readmemh("words", m, 3, 0);
  assign q = m[a];
endmodule
