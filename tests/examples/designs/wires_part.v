`include "stepped.vh"
module wires_part(input wire clk, input wire [7:0] d, output wire [7:0] q);
  reg [7:0] last;
  assign q = last;
  always @(posedge clk) last <= `STEPPED(d);
endmodule
