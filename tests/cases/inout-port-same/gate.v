module t(input en, d, inout pad, output y);
  bufif1 g(pad, d, en);
  assign y = d ^ pad;
endmodule
