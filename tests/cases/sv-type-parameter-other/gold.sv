// A parameter that is a type.
module below #(parameter type T = logic)(input T a, output T y);
  assign y = a >>> 1;
endmodule
module t(input [3:0] a, output [3:0] y);
  below #(.T(logic signed [3:0])) u(.a, .y);
endmodule
