// Pins of both directions: an open-drain line, which two pads below pull down, and a bus of 4 bits that is
// driven while `give` was 1. What stands on both is read. The clock comes through a vendor's buffer, a module
// that no file has.
module pad (
    inout wire line,
    input wire low
);
  assign line = low ? 1'b0 : 1'bz;
endmodule

module pads #(parameter FAULT = 0) (clk, rst, pull, give, value, sda, bus, lost, seen);
  input clk, rst, give;
  input [1:0] pull;
  input [3:0] value;
  inout sda;
  inout [3:0] bus;
  output reg lost;
  output reg [3:0] seen;
  reg [1:0] low;
  reg giving;
  wire ck;
  CLKBUF buffer (.O(ck), .I(clk));
  pad one (.line(sda), .low(low[0]));
  pad two (.low(low[1]), .line(sda));
  assign bus = giving ? (FAULT != 0 && seen == 4'd9 ? {4{1'bz}} : seen) : 4'bzzzz;
  always @(posedge ck)
    if (rst) begin
      low <= 2'd0;
      giving <= 1'b0;
      seen <= 4'd0;
      lost <= 1'b0;
    end else begin
      low <= pull;
      giving <= give;
      seen <= give ? value : bus;
      lost <= low == 2'd0 && !sda;
    end
endmodule
