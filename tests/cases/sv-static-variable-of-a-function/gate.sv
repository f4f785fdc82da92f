module t(input logic clk, input logic [7:0] a, output logic [7:0] q);
  always_ff @(posedge clk) q <= a;
endmodule
