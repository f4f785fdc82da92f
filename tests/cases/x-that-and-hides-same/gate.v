module t(input a, output [1:0] y);
  assign y = {1'b0, 1'b1};
endmodule
