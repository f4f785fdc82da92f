module t(input clk, rst, output y);
  reg [40:0] c;
  always @(posedge clk)
    if (rst) c <= 0;
    else c <= c * 5 + 3;
  assign y = 0;
endmodule
