package gp;
  logic [7:0] g = 0;
endpackage
module t(input logic clk, input logic [7:0] d, output logic [7:0] y);
  always_ff @(posedge clk) if (d == 7) gp::g <= 1;
  assign y = d + gp::g;
endmodule
