module t(input a, b, output y);
  // A text may be long.
  PLL #(.P("a_name_of_more_than_32_characters_of_1_file.hex")) p(.A(a), .Y(y));
endmodule
