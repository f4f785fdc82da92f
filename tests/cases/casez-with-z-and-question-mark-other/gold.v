// In casez z and ? are wildcards.
module t(input [2:0] s, output reg [1:0] y);
  always @*
    casez (s)
      3'b1?z: y = 1;
      3'b01z: y = 2;
      default: y = 3;
    endcase
endmodule
