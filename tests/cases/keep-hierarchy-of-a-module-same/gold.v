// The attribute keep_hierarchy at a module.
module t(input a, b, output y);
  below u(a, b, y);
endmodule
(* keep_hierarchy *) module below(input a, b, output y);
  assign y = a & b;
endmodule
