module b(input x, output y);
  assign y = x;
endmodule
