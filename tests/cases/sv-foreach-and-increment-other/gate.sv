module t(input [7:0] a, output logic [3:0] y);
  assign y = a[1:0] + a[3:2] + a[5:4] + a[7:6] + 4'd3;
endmodule
