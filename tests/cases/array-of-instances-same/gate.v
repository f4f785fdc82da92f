module t(input [5:0] a, input e, output [2:0] y);
  assign y = {a[5] | ~a[4], a[3] | ~a[2], a[1] | ~a[0]} & {3{e}};
endmodule
