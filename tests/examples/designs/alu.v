// Logic without a register and without a clock: an arithmetic unit with flags.
module alu #(parameter FAULT = 0) (
    input  wire [7:0] a, b,
    input  wire [1:0] operation,
    output reg  [7:0] result,
    output wire       zero,
    output reg        carry
);
  assign zero = result == 8'd0;
  always @* begin
    carry = 1'b0;
    case (operation)
      2'd0: {carry, result} = a + b;
      2'd1: {carry, result} = {1'b0, a} - {1'b0, b};
      2'd2: result = a & b;
      default: result = a ^ (FAULT != 0 && a == 8'h5a ? 8'h00 : b);
    endcase
  end
endmodule
