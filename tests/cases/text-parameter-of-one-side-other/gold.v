// A text as a parameter of one side.
module t #(parameter M = "A")(input a, output y);
  assign y = M == "A" ? a : ~a;
endmodule
