module t(input signed [3:0] a, output signed [3:0] y);
  assign y = a[3] & |a[1:0] ? {2'b11, a[1:0]} : {2'b00, a[1:0]};
endmodule
