module t #(parameter type T = logic [3:0]) (input logic clk, input T d, output T q);
  T sum;
  assign sum = $bits(T) > 5 ? d + q : d - q;
  always_ff @(posedge clk) q <= sum;
endmodule
