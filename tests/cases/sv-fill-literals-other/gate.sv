module t(input [7:0] a, input [39:0] b, output [7:0] y, output z);
  assign y = a ^ 8'd1;
  assign z = &b;
endmodule
