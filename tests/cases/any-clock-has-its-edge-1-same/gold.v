// Any set of the clocks has its edge on a step.
module t(input a, b, rst, input [1:0] d, output [1:0] q);
  reg [1:0] p, r;
  assign q = r;
  always @(posedge a) if (rst) p <= 0;
  else p <= d;
  always @(negedge b) if (rst) r <= 0;
  else r <= ~p;
endmodule
