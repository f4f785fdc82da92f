module t(input a, b, output y);
  (* keep_hierarchy *) below u(a, b, y);
endmodule
module below(input a, b, output y);
  assign y = a | b;
endmodule
