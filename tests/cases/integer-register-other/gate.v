module t(input clk, rst, input [3:0] d, output y);
  reg [31:0] r;
  always @(posedge clk)
    if (rst) r <= 0;
    else r <= r - d;
  assign y = r < -20;
endmodule
