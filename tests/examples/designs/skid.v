// A register of an AXI stream: its data is not reset. The fault: it takes a byte while it is full.
module skid_buffer #(parameter FAULT = 0) (
    input  wire       clk, rst, in_valid,
    input  wire [7:0] in_data,
    output wire       in_ready,
    output reg        out_valid,
    output reg  [7:0] out_data,
    input  wire       out_ready
);
  assign in_ready = !out_valid || out_ready;
  always @(posedge clk) begin
    if (in_ready) out_valid <= in_valid;
    if ((in_ready || (FAULT != 0 && out_data[1:0] == 2'd3)) && in_valid) out_data <= in_data;
    if (rst) out_valid <= 1'b0;
  end
endmodule
