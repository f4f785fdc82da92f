module t(input [7:0] a, output [7:0] y);
  wire [7:0] p = {a[5], a[2], a[7], a[4], a[1], a[6], a[3], a[0]};
  assign y = p ^ {p[6:0], 1'b0};
endmodule
