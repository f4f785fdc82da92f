// All are signed, so the item -1 is three.
module t(input signed [1:0] s, output reg y);
  always @*
    case (s)
      -1: y = 1;
      default: y = 0;
    endcase
endmodule
