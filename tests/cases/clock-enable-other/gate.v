module t(input clk, rst, en, d, output reg q);
  always @(posedge clk)
    if (en)
      if (rst) q <= 0;
      else q <= d;
endmodule
