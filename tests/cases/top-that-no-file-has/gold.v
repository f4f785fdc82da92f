module a(input x, output y);
  assign y = x;
endmodule
