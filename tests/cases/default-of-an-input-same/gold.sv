module inc #(parameter int W = 4) (input logic [W-1:0] d, input logic by = 1'b1, output logic [W-1:0] q);
  assign q = d + W'(by);
endmodule
module t(input logic clk, rst, en = 1'b1, output logic [3:0] n = 4'd0);
  logic [3:0] more;
  inc i(.d(n), .by(1'b1), .q(more));
  always_ff @(posedge clk) if (rst) n <= 0; else if (en) n <= more;
endmodule
