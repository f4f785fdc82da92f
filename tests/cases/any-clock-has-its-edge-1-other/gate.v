module t(input a, b, rst, input [1:0] d, output [1:0] q);
  reg [1:0] p, r;
  assign q = r;
  always @(posedge a) if (rst) p <= 0;
  else p <= d;
  always @(negedge b) if (rst) r <= 0;
  else r <= p == 3 ? 1 : ~p;
endmodule
