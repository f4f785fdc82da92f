module t(input [7:0] a, input signed [2:0] n, output [7:0] y);
  wire [2:0] count = n;
  assign y = a >> count;
endmodule
