module t(input [3:0] a, output [15:0] y);
  wire [31:0] s = a + 3;
  assign y = {s[12:0], 3'd0};
endmodule
