module t(input [4:0] d, output [4:0] y);
  assign y = d ^ 5'b10010;
endmodule
