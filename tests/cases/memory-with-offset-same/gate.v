module t(input clk, we, input [2:0] a, input [1:0] d, output [1:0] q);
  reg [1:0] n [0:3];
  always @(posedge clk) if (we & a[2]) n[a[1:0]] <= d;
  assign q = a[2] ? n[a[1:0]] : 2'd0;
endmodule
