module t #(parameter type T = logic [3:0]) (input logic clk, input T d, output T q);
  always_ff @(posedge clk) q <= T'(q + d);
endmodule
