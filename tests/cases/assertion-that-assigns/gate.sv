module t(input logic clk, a, input logic [31:0] d, output logic y);
  always_ff @(posedge clk) y <= a;
  assert property (@(posedge clk) d != 0) else $error("d = %h", d);
endmodule
