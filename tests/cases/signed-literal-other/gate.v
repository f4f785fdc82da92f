module t(input signed [7:0] a, output y);
  assign y = a == 8'h0f;
endmodule
