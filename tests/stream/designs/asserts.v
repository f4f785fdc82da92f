// A register between two streams that says itself when a number is out of its range.
module asserts #(parameter FAULT = 0) (
    input  wire       clk, rst,
    input  wire       x_valid,
    output wire       x_ready,
    input  wire [7:0] x_data,
    output reg        y_valid,
    input  wire       y_ready,
    output reg  [7:0] y_data
);
  assign x_ready = !y_valid || y_ready;
  always @(posedge clk) begin
    if (rst) y_valid <= 0;
    else if (x_ready) y_valid <= x_valid;
    if (x_ready) y_data <= x_data;
    if (FAULT == 1 && y_valid && y_data > 100) $error("%0d is more than 100", y_data);
  end
endmodule
