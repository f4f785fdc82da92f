// A register between two streams, with the parity of what it holds. With FAULT that of a number over
// 100 is wrong. Its models do the same, so that only what it asserts itself can show it.
module guarded #(parameter FAULT = 0) (
    input  wire       clk, rst,
    input  wire       x_valid,
    output wire       x_ready,
    input  wire [7:0] x_data,
    output reg        y_valid,
    input  wire       y_ready,
    output reg  [7:0] y_data
);
  reg odd;
  assign x_ready = !y_valid || (y_valid && y_ready);  // which makes some mutants the same
  always @(posedge clk) begin
    if (rst) y_valid <= 0;
    else if (x_ready) y_valid <= x_valid;
    if (x_ready) begin
      y_data <= x_data;
      odd <= ^x_data ^ (FAULT == 1 && x_data > 100);
    end
    if (y_valid) assert (odd == ^y_data);
  end
endmodule
