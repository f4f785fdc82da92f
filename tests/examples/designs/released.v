// A counter whose reset is a register: the reset begins at once and is released by two clocks, and it begins
// on a clock, too.
module released #(parameter FAULT = 0) (
    input  wire       clk, rst_n, stop, en,
    output wire [2:0] q
);
  reg       first, ready;
  reg [2:0] count;
  assign q = count;
  always @(posedge clk or negedge rst_n) begin
    if (!rst_n) begin
      first <= 1'b0;
      ready <= 1'b0;
    end else begin
      first <= 1'b1;
      ready <= first & ~stop;
    end
  end
  always @(posedge clk or negedge ready) begin
    if (!ready) count <= 3'd5;
    else if (en) count <= count + (FAULT != 0 && count == 3'd0 ? 3'd2 : 3'd1);
  end
endmodule
