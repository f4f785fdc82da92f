// A register between two streams, and one that no reset reaches: it keeps what passed last. With FAULT
// the first value behind a reset is wrong where the low half of that one is 0.
module keeps #(parameter FAULT = 0) (
    input  wire       clk, rst,
    input  wire       x_valid,
    output wire       x_ready,
    input  wire [7:0] x_data,
    output reg        y_valid,
    input  wire       y_ready,
    output reg  [7:0] y_data
);
  reg [7:0] last;
  reg first;
  assign x_ready = !y_valid || y_ready;
  always @(posedge clk) begin
    if (x_ready) y_valid <= x_valid;
    if (x_valid && x_ready) begin
      y_data <= x_data ^ {7'd0, FAULT == 1 && first && last[3:0] == 0};
      last   <= x_data;
      first  <= 0;
    end
    if (rst) begin
      y_valid <= 0;
      first   <= 1;
      last    <= last;
    end
  end
endmodule
