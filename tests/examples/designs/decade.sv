// A counter of ten. What it does above nine, where it never is, is not what its model does.
module decade #(parameter FAULT = 0) (
    input  wire       clk, rst, en,
    output wire [3:0] digit,
    output wire       carry
);
  reg [3:0] digit_q;
  assign digit = digit_q;
  assign carry = en & digit_q[3] & digit_q[0];
  always @(posedge clk)
    if (rst) digit_q <= 4'd0;
    else if (en) digit_q <= digit_q[3] & digit_q[0] ? (FAULT != 0 ? 4'd10 : 4'd0) : digit_q + 4'd1;
  always @* if (!rst) assert (digit_q < 4'd10);
endmodule
