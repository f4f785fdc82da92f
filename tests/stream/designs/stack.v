// Two places between two streams. With FAULT the one filled last is emptied first.
module stack #(parameter FAULT = 0) (
    input  wire       clk, rst,
    input  wire       x_valid,
    output wire       x_ready,
    input  wire [7:0] x_data,
    output wire       y_valid,
    input  wire       y_ready,
    output wire [7:0] y_data
);
  reg [1:0] held;
  reg [7:0] first, second;
  wire takes = x_valid && x_ready, gives = y_valid && y_ready;
  wire last_first = FAULT == 1 && held == 2;
  assign x_ready = held != 2;
  assign y_valid = held != 0;
  assign y_data  = last_first ? second : first;
  always @(posedge clk) begin
    held <= rst ? 2'd0 : held + {1'b0, takes} - {1'b0, gives};
    if (gives && !last_first) first <= second;
    if (takes && held == {1'b0, gives}) first <= x_data;
    if (takes && held != {1'b0, gives}) second <= x_data;
  end
endmodule
