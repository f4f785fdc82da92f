// bufif1 as one of two drivers.
module t(input a, b, s, output y);
  wire w;
  bufif1 g0(w, a, s);
  bufif0 g1(w, b, s);
  assign y = w;
endmodule
