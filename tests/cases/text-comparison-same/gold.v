// Texts of two lengths are compared with zeros before the shorter one.
module t(input a, output y);
  localparam [39:0] T = "ab";
  assign y = (T == "ab") ? a : ~a;
endmodule
