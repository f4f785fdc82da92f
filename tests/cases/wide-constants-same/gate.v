module t(input [69:0] a, output [69:0] y);
  assign y = {~a[69:64], a[63:33], ~a[32], a[31:0]};
endmodule
