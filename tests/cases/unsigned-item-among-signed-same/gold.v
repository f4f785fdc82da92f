// One unsigned item makes all of the comparison unsigned, so -1 is 2^32 - 1.
module t(input signed [1:0] s, output reg [1:0] y);
  always @*
    case (s)
      -1: y = 1;
      2'd1: y = 2;
      default: y = 0;
    endcase
endmodule
