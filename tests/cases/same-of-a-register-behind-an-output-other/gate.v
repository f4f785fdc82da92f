module t(input clk, d, output y);
  reg r = 0;
  always @(posedge clk) r <= ~d;
  assign y = r;
endmodule
