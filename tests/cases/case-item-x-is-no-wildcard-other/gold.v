// In a plain case 2'b1x matches nothing where s is known.
module t(input [1:0] s, output reg y);
  always @*
    case (s)
      2'b1x: y = 1;
      default: y = 0;
    endcase
endmodule
