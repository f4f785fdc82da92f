module t(input clk, input d, output reg q);
  always @(posedge clk) q <= d;
  // synthesis translate_off
  event seen;
  always @(posedge clk) begin
    -> seen;
    if (d === 1'bx) $display("d is unknown at %t", $time);
  end
  // synthesis translate_on
endmodule
