module t(input [2:0] a, output logic [2:0] y);
  assign y = a == 2 ? 3'd3 : a == 3 ? 3'd4 : a == 4 ? 3'd5 : 3'd2;
endmodule
