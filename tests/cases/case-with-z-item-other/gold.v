// In a plain case z is no wildcard.
module t(input [2:0] s, output reg [1:0] y);
  always @*
    case (s)
      3'b1zz: y = 1;
      3'b1??: y = 2;
      default: y = 3;
    endcase
endmodule
