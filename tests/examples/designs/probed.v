// A counter with an instance that only watches it: its registers, and an output that is not used,
// are nobody's business.
module probed #(parameter FAULT = 0) (
    input  wire       clk,
    input  wire       rst,
    input  wire       en,
    output wire [3:0] q,
    output wire [99:0] spare
);
  wire [3:0] count;
  assign q = count;
  wire was;
  assign spare = {was, {33{count[2:0]}}};
  probed_counter #(.FAULT(FAULT)) counter (.clk(clk), .rst(rst), .en(en), .value(count));
  probed_debug debug (.clk(clk), .en(en), .was(was));
endmodule
module probed_counter #(parameter FAULT = 0) (
    input  wire       clk,
    input  wire       rst,
    input  wire       en,
    output reg  [3:0] value
);
  always @(posedge clk)
    if (rst) value <= 4'd0;
    else if (en) value <= value + (FAULT != 0 && value == 4'd6 ? 4'd2 : 4'd1);
endmodule
module probed_debug (
    input  wire clk,
    input  wire en,
    output wire was
);
  reg [3:0] busy, idle;
  reg       seen [0:79];  // more than Verilator unrolls by itself
  integer   i;
  assign was = seen[busy];
  always @(posedge clk)
    if (idle == 4'd0) for (i = 0; i < 80; i = i + 1) seen[i] <= 1'b0;
    else seen[busy] <= 1'b1;
  always @(posedge clk)
    if (en) busy <= busy + 4'd1;
    else idle <= idle + 4'd1;
endmodule
