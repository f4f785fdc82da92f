module t(input [7:0] a, output [7:0] y);
  wire [7:0] v = {4'd0, a[4:1]};
  assign y = a[0] ? {a[7:5], 5'd0} : v;
endmodule
