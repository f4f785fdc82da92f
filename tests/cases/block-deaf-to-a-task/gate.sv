module t(input clk, rst, input [7:0] a, b, output logic [7:0] y);
  always_ff @(posedge clk) y <= rst ? 0 : a >= 3 && a <= 9 ? b : a;
endmodule
