// case (1'b1): the first item that is 1.
module t(input [2:0] s, output reg [1:0] y);
  always @*
    case (1'b1)
      s[0]: y = 0;
      s[1]: y = 1;
      s[2]: y = 2;
      default: y = 3;
    endcase
endmodule
