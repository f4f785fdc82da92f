// Escaped names of nets, one of them a word of the language.
module t(input a, b, output y);
  wire \a+b , \module ;
  assign \a+b = a | b;
  assign \module = a & b;
  assign y = \a+b ^ \module ;
endmodule
