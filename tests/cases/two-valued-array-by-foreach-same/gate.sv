module t(input logic clk, input logic [4:0] d, output logic y);
  bit [4:0] m;
  always_ff @(posedge clk) m <= d;
  assign y = m[0] ^ m[1] ^ m[2] ^ m[3] ^ m[4];
endmodule
