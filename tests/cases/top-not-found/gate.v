module gate(input a, output y);
  assign y = a;
endmodule
module other(input a, output y);
  assign y = ~a;
endmodule
