// Events of one clock counted by another, on its falling edge: each turns a bit over, which two flip-flops
// of the other clock sample. Each side has a reset of its own, one at its clock and one at once.
module domains #(parameter FAULT = 0) (
    input  wire       a_clk, a_rst, send, b_clk, b_rst_n,
    output wire [2:0] q
);
  reg       turned;  // over, on each event
  reg       first, second, last;
  reg [2:0] seen;
  assign q = seen;

  always @(posedge a_clk) begin
    if (a_rst) turned <= 1'b0;
    else if (send) turned <= ~turned;
  end

  // The fault is a flip-flop on the wrong side.
  generate
    if (FAULT == 0) begin : sampled
      always @(negedge b_clk or negedge b_rst_n)
        if (!b_rst_n) first <= 1'b0;
        else first <= turned;
    end else begin : sampled
      always @(posedge a_clk or negedge b_rst_n)
        if (!b_rst_n) first <= 1'b0;
        else first <= turned;
    end
  endgenerate
  always @(negedge b_clk or negedge b_rst_n) begin
    if (!b_rst_n) begin
      second <= 1'b0;
      last   <= 1'b0;
      seen   <= 3'd0;
    end else begin
      second <= first;
      last   <= second;
      if (second != last) seen <= seen + 3'd1;
    end
  end
endmodule
