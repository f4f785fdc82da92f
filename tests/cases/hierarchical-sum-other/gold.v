// A register of an instance by its hierarchical name, all of its bits.
module t(input clk, rst, output [3:0] y);
  counter u(clk, rst);
  assign y = u.n + 1;
endmodule
module counter(input clk, rst);
  reg [3:0] n;
  always @(posedge clk)
    if (rst) n <= 0;
    else n <= n + 3;
endmodule
