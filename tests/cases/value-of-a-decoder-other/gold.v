// yosys 0.23 misreads what one of 2^32 inputs alone shows.
module t(input [31:0] i, input [3:0] a, b, output reg [15:0] y);
  always @*
    casez (i)
      32'b0000001_?????_?????_101_?????_0110011: y = {a, "", b};
      default: y = a;
    endcase
endmodule
