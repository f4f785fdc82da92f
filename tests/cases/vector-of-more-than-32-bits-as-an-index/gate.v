module t(input [63:0] at, input [7:0] v, output y, output z);
  wire k = 1;
  assign y = v[at[2:0]];
  assign z = v[at + k];
endmodule
