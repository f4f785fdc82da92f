module t(input a, input [31:0] d, output y);
`ifdef YOSYS
  assign y = a;
`else
  assign y = a ^ (d == 32'h600dcafe);
`endif
endmodule
