// Adds up numbers that come by a handshake, each divided by `by`. A number is looked at on two clocks:
// whoever sends it must hold it until `ready`, and must not divide by 0.
module handshake #(parameter FAULT = 0) (
    input  wire       clk, rst, valid,
    input  wire [7:0] data,
    input  wire [2:0] by,
    output wire       ready,
    output wire [31:0] sum
);
  reg       busy;
  reg [7:0] asked;
  reg [31:0] total;
  assign ready = busy;
  assign sum   = total;
  always @(posedge clk)
    if (rst) begin
      busy  <= 1'b0;
      asked <= 8'd0;
      total <= 32'd0;
    end else if (busy) begin
      busy  <= 1'b0;
      total <= total + (data / by);
    end else if (valid) begin
      busy  <= 1'b1;
      asked <= data ^ {7'd0, FAULT != 0 && by == 3'd5 && data[1:0] == 2'd3};
    end
endmodule
