// Multiplies bit by bit: `a` and `b` with `start`, and when `busy` falls again the product. No reset
// reaches what it adds up; the fault looks at that, as it powered up or was left by another product.
module serial #(parameter FAULT = 0) (
    input  wire        clk, rst, start,
    input  wire [7:0]  a, b,
    output wire        busy,
    output wire [15:0] product
);
  reg [3:0]  left;
  reg [15:0] sum, shifted;
  reg [7:0]  rest;
  assign busy    = left != 4'd0;
  assign product = sum;
  always @(posedge clk)
    if (rst) left <= 4'd0;
    else if (busy) begin
      left    <= left - 4'd1;
      sum     <= rest[0] ? sum + shifted : sum;
      shifted <= {shifted[14:0], 1'b0};
      rest    <= {1'b0, rest[7:1]};
    end else if (start) begin
      left    <= 4'd8;
      sum     <= {15'd0, FAULT != 0 && sum[15:14] == 2'd3};
      shifted <= {8'd0, a};
      rest    <= b;
    end
endmodule
