module t #(parameter M = "A")(input a, output y);
  assign y = M == "A" ? a : ~a;
endmodule
