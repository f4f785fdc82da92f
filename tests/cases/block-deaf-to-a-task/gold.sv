module t(input clk, rst, input [7:0] a, b, output logic [7:0] y);
  logic [7:0] r;
  task automatic put(input [7:0] i);
    r = i inside {[8'd3:8'd9]} ? b : i;
  endtask
  always @(*) begin put(a); end
  always_ff @(posedge clk) y <= rst ? 0 : r;
endmodule
