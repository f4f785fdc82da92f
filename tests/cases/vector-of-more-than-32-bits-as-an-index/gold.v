module t(input [63:0] at, input [7:0] v, output y, output z);
  assign y = v[at[2:0]];
  assign z = v[at + 1];
endmodule
