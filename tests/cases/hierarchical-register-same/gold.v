// A register of an instance by its hierarchical name.
module t(input clk, rst, output [1:0] y);
  counter u(clk, rst);
  assign y = u.n;
endmodule
module counter(input clk, rst);
  reg [1:0] n;
  always @(posedge clk)
    if (rst) n <= 0;
    else n <= n + 1;
endmodule
