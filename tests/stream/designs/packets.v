// Packets of bytes: after the last byte of each comes one word, the exclusive or of its bytes and how
// many there were. What comes out is always taken.
module packets #(parameter FAULT = 0) (
    input  wire       clk, rst,
    input  wire       s_axis_tvalid,
    output wire       s_axis_tready,
    input  wire [7:0] s_axis_tdata,
    input  wire       s_axis_tlast,
    output reg        sum_valid,
    output reg  [7:0] sum_parity,
    output reg  [7:0] sum_length
);
  reg  [7:0] parity, length;
  // It never takes two bytes on clocks that follow each other.
  reg  rest;
  assign s_axis_tready = !rest;
  wire taken = s_axis_tvalid && s_axis_tready;
  always @(posedge clk) begin
    rest      <= !rst && taken;
    sum_valid <= !rst && taken && s_axis_tlast;
    if (rst) begin
      parity <= 0;
      length <= 0;
    end else if (taken) begin
      parity <= s_axis_tlast ? 8'd0 : parity ^ s_axis_tdata;
      length <= s_axis_tlast ? 8'd0 : length + 8'd1;
      // The fault: the last byte of a packet of three is not added.
      sum_parity <= parity ^ (FAULT == 1 && length == 2 ? 8'd0 : s_axis_tdata);
      sum_length <= length + 8'd1;
    end
  end
endmodule
