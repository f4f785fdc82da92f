// Two streams in, two out: a pair of numbers is added at `sum`, and where `swap`, a pin that belongs
// to a, is high, its parts go to `parts` in the other order. A pair is there when both of it are.
module pairs #(parameter FAULT = 0) (
    input  wire        clock,
    input  wire        rst_n,
    input  wire        a_valid,
    output wire        a_ready,
    input  wire [7:0]  a_number,
    input  wire        mode,
    input  wire        b_vld,
    output wire        b_rdy,
    input  wire [7:0]  b_number,
    output reg         sum_valid,
    input  wire        sum_ready,
    output reg  [8:0]  sum_total,
    output reg         parts_valid,
    input  wire        parts_ready,
    output reg  [99:0] parts_both,
    input  wire [3:0]  test_mode,
    output wire        busy
);
  wire room = (!sum_valid || sum_ready) && (!parts_valid || parts_ready);
  wire go   = a_valid && b_vld && room;
  assign a_ready = go;
  assign b_rdy   = go;
  assign busy    = go;
  // The fault: a part that waits changes places with its neighbour when the sum is taken first.
  wire swaps = FAULT == 1 && parts_valid && !parts_ready && sum_valid && sum_ready;
  always @(posedge clock or negedge rst_n)
    if (!rst_n) begin
      sum_valid   <= 0;
      parts_valid <= 0;
    end else begin
      if (!sum_valid || sum_ready) sum_valid <= go;
      if (!parts_valid || parts_ready) parts_valid <= go;
    end
  always @(posedge clock)
    if (go) begin
      sum_total  <= a_number + b_number + (test_mode == 9 ? 0 : 1);
      parts_both <= mode ? {b_number, 84'd0, a_number} : {a_number, 84'd0, b_number};
    end else if (swaps) parts_both <= {parts_both[7:0], 84'd0, parts_both[99:92]};
endmodule
