// Events of one clock counted, and the count seen by another clock, in Gray code through two flip-flops: one
// bit of it changes at a time, so that whatever the first of them takes is a count of before or of now.
// The fault is that it crosses as a binary number. What is seen must never be more than was counted.
module counted #(parameter FAULT = 0) (
    input  wire       rst_n, a_clk, tick, b_clk,
    output wire [3:0] seen
);
  reg  [3:0] count;
  reg  [3:0] code;           // of the count
  reg  [3:0] first, second;  // the same, at the other clock
  wire [3:0] next = count + {3'd0, tick & (count != 4'd15)};

  always @(posedge a_clk or negedge rst_n) begin
    if (!rst_n) begin
      count <= 4'd0;
      code  <= 4'd0;
    end else begin
      count <= next;
      code  <= FAULT != 0 ? next : next ^ (next >> 1);
    end
  end
  always @(posedge b_clk or negedge rst_n) begin
    if (!rst_n) begin
      first  <= 4'd0;
      second <= 4'd0;
    end else begin
      first  <= code;
      second <= first;
    end
  end
  assign seen = FAULT != 0 ? second : second ^ (second >> 1) ^ (second >> 2) ^ (second >> 3);

  always @* never_more: assert (seen <= count);
endmodule
