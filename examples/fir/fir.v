// A filter of five taps, y[n] = 9 x[n-2] + 5 (x[n-1] + x[n-3]) - (x[n] + x[n-4]). In STAGES = 1 all
// of it is one sum; with STAGES = 3 the pairs, the products and the sum stand in registers of their
// own. A stage moves where the next one is empty or moves.
module fir #(
    parameter W = 8,
    parameter STAGES = 1
) (
    input  wire                clk,
    input  wire                rst,
    input  wire                x_valid,
    output wire                x_ready,
    input  wire signed [W-1:0] x_data,
    output wire                y_valid,
    input  wire                y_ready,
    output wire signed [W+4:0] y_data
);
  wire [STAGES:1] valid;
  wire [STAGES:1] moves;
  assign x_ready = moves[1];
  assign y_valid = valid[STAGES];

  genvar i;
  generate
    for (i = 1; i <= STAGES; i = i + 1) begin : stage
      reg  full;
      wire next_moves;
      if (i == STAGES) assign next_moves = y_ready;
      else assign next_moves = moves[i+1];
      assign moves[i] = !full || next_moves;
      assign valid[i] = full;
      wire comes;
      if (i == 1) assign comes = x_valid;
      else assign comes = valid[i-1];
      always @(posedge clk)
        if (rst) full <= 1'b0;
        else if (moves[i]) full <= comes;
    end
  endgenerate

  // The four samples before this one.
  reg signed [W-1:0] x1, x2, x3, x4;
  wire taken = x_valid && x_ready;
  always @(posedge clk)
    if (rst) begin
      x1 <= 0;
      x2 <= 0;
      x3 <= 0;
      x4 <= 0;
    end else if (taken) begin
      x1 <= x_data;
      x2 <= x1;
      x3 <= x2;
      x4 <= x3;
    end

  wire signed [W+4:0] outer  = x_data + x4;
  wire signed [W+4:0] inner  = x1 + x3;
  wire signed [W+4:0] middle = x2;
  reg signed  [W+4:0] sum;
  assign y_data = sum;
  generate
    if (STAGES == 1) begin : at_once
      always @(posedge clk) if (moves[1]) sum <= 9 * middle + 5 * inner - outer;
    end else begin : in_steps
      reg signed [W+4:0] outer1, inner1, middle1, inner5, rest;
      always @(posedge clk) begin
        if (moves[1]) begin
          outer1  <= outer;
          inner1  <= inner;
          middle1 <= middle;
        end
        if (moves[2]) begin
          inner5 <= 5 * inner1;
          rest   <= 9 * middle1 - outer1;
        end
        if (moves[3]) sum <= inner5 + rest;
      end
    end
  endgenerate
endmodule
