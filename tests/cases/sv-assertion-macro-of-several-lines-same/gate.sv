module t(input logic clk, input logic rst, input logic [3:0] d, output logic [3:0] q);
  always_ff @(posedge clk) if (rst) q <= 0; else q <= 1 + d;
endmodule
