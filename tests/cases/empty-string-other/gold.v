// An empty string in a concatenation is one byte of zeros.
module t(input [3:0] a, b, output [15:0] y);
  assign y = {a, "", b};
endmodule
