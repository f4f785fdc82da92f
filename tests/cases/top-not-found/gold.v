module gold(input a, output y);
  assign y = a;
endmodule
