// The value of a signed operand is extended to the width of the selection.
module t(input [2:0] at, input signed [1:0] n, output reg [11:0] y);
  always @* begin
    y = 12'd0;
    y[at +: 4] = n;
  end
endmodule
