// In casez x is no wildcard.
module t(input [2:0] s, output reg [1:0] y);
  always @*
    casez (s)
      3'b1?x: y = 1;
      3'b1??: y = 2;
      default: y = 3;
    endcase
endmodule
