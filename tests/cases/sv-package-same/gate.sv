module t(input [3:0] a, output [3:0] y);
  assign y = {a[0], ~a[3], a[2:1]};
endmodule
