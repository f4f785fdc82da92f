module t(input signed [3:0] a, input [3:0] b, output [3:0] y);
  wire [3:0] n = a[3] ? -a : a;
  wire [3:0] q = n / b;
  assign y = b == 0 ? 4'd0 : a[3] ? -q : q;
endmodule
