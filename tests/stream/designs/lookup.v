// FAULT 1: the square of 9 is wrong.
module lookup #(parameter FAULT = 0) (
    input  wire       clk,
    input  wire       rst,
    input  wire       x_valid,
    output wire       x_ready,
    input  wire [3:0] x_key,
    output reg        y_valid,
    input  wire       y_ready,
    output reg        y_hit,
    output reg  [7:0] y_data
);
  wire [7:0] key = {4'd0, x_key};
  wire [7:0] square = key * key;
  assign x_ready = !y_valid || y_ready;
  always @(posedge clk) begin
    if (x_ready) begin
      y_hit  <= x_key < 4'd10;
      y_data <= square - (FAULT == 1 && x_key == 4'd9 ? 8'd1 : 8'd0);
    end
    y_valid <= !rst && (x_ready ? x_valid : y_valid);
  end
endmodule
