module t(input a, input [31:0] d, output y);
  assign y = a
  // synopsys translate_off
      ^ (d == 32'h600dcafe)
  // synopsys translate_on
  ;
endmodule
