module t(input [69:0] a, output [69:0] y);
  assign y = {~a[69:64], a[63:33], ~a[32], a[31:5], ~a[4], a[3:0]};
endmodule
