module t(input [1:0] a, output [1:0] y);
  assign y = ~{a[1], a[0]};
endmodule
