module wide(input [63:0] at, output y); assign y = ^at; endmodule
module t(input [2:0] at, input [63:0] d, input [7:0] v, output y, output z);
  wide w(.at(d), .y(y));
  assign z = v[at];
endmodule
