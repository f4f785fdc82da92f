// Words that a file of $readmemh lacks are x.
module t(input [1:0] a, output [3:0] q);
  reg [3:0] m [0:3];
  initial $readmemh("words", m);
  assign q = m[a];
endmodule
