module t(input [5:0] a, output [2:0] y);
  assign y = {a[1] | ~a[0], a[3] | ~a[2], a[5] | ~a[4]};
endmodule
