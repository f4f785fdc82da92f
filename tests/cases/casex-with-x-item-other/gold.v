// In casex x is a wildcard.
module t(input [2:0] s, output reg [1:0] y);
  always @*
    casex (s)
      3'b1xz: y = 1;
      3'bx1?: y = 2;
      default: y = 3;
    endcase
endmodule
