// A digit x in a file of $readmemb: any value will do.
module t(input [1:0] a, output [3:0] q);
  reg [3:0] m [0:3];
  initial $readmemb("words", m);
  assign q = m[a];
endmodule
