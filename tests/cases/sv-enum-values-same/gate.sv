module t(input [2:0] a, output logic [2:0] y);
  assign y = a == 2 ? 3'd3 : a == 3 ? 3'd6 : a == 6 ? 3'd7 : 3'd2;
endmodule
