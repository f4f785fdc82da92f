module t(input [1:0] s, input [3:0] a, output logic [3:0] y);
  assign y = s[1] ? a : a ^ {4{s[0]}};
endmodule
