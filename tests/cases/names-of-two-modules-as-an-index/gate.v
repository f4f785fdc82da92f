module t(input [2:0] at, input [63:0] d, input [7:0] v, output y, output z);
  assign y = ^d;
  wire [7:0] moved = v >> at;
  assign z = moved[0];
endmodule
