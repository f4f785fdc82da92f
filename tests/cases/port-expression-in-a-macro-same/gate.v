module t(input [7:0] a, input [7:0] b, output [15:0] y, output [15:0] z);
  assign y = {8'd0, a} + {8'd0, b};
  assign z = {7'd0, a, 1'b0};
endmodule
