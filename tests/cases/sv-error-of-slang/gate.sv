module t(input logic clk, input logic [7:0] a, output logic q);
  always_ff @(posedge clk) q <= a inside {1, 2};
endmodule
