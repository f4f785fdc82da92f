module t(input a, output y);
  localparam K = "$Format:%H$";
  assign y = a ^ (K[7:0] == "$");
endmodule
