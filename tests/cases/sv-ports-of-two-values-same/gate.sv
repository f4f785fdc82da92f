module t(input bit [3:0] a, input int b, output bit y);
  wire [3:0] shifted = a >> b[1:0];
  assign y = shifted[0];
endmodule
