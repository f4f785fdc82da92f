module t(input logic clk, input logic [4:0] d, output logic y);
  bit [4:0] m;
  always_ff @(posedge clk) foreach (m[i]) m[i] <= d[i];
  assign y = ^m;
endmodule
