module t(input [2:0] n, output signed [3:0] y);
  assign y = n[0] ? 4'hf : 4'h1;
endmodule
