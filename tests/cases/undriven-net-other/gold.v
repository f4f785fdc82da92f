// A net without a driver is x: in the old RTL anything will do, in the new one only what holds for every value.
module t(input a, output y);
  wire n;
  assign y = a ? n : 1'b0;
endmodule
