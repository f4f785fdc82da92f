module t(input [1:0] a, output [3:0] y);
  assign y = {2'b00, ~a};
endmodule
