module t(input clk, input rst, input d, output q);
  reg [1:5] t;
  assign q = t[1];
  always @(posedge clk) t <= {t[2:5], d};
endmodule
