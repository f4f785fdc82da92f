// Registers that parameters switch off, as parametrised parts have them: one that is always 0 then,
// two that are the same, one that drives nothing in a block of its own.
module folded #(parameter FAULT = 0, parameter TAGS = 0, parameter DROPS = 0) (
    input  wire       clk, rst,
    input  wire [3:0] d,
    input  wire       valid,
    output reg  [3:0] q,
    output wire [3:0] tag,
    output reg        dropped, bad
);
  reg [1:0] count;
  wire      drop = DROPS ? valid && count == 2'd3 : 1'b0;
  generate
    if (1) begin : tags
      reg [3:0] held;
      always @(posedge clk) if (valid) held <= d;
      assign tag = TAGS ? held : 4'd0;
    end
  endgenerate
  always @(posedge clk) begin
    dropped <= drop;
    bad     <= drop;
    if (valid) begin
      q     <= d ^ (FAULT != 0 && d == 4'd9 ? 4'd1 : 4'd0);
      count <= count + 2'd1;
    end
    if (rst) begin
      dropped <= 1'b0;
      bad     <= 1'b0;
      count   <= 2'd0;
    end
  end
endmodule
