// Only slang reads `inside`; its error names the line of the name that is not declared.
module t(input logic clk, input logic [7:0] a, output logic q);
  always_ff @(posedge clk) q <= a inside {1, 2} && nosuch;
endmodule
