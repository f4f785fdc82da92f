// Squares numbers in two clocks. What its registers and its output hold while no number is in them is
// nobody's business: they are not reset, and take whatever comes.
module pipe #(parameter FAULT = 0) (
    input  wire       clk, rst, valid,
    input  wire [5:0] data,
    output wire       done,
    output wire [7:0] result
);
  reg       busy, last;
  reg [5:0] number;
  reg [7:0] square;
  assign done   = last;
  assign result = square;
  always @(posedge clk) begin
    busy   <= valid & !rst;
    last   <= busy & !rst;
    number <= data;
    square <= {2'b0, number} * {2'b0, number} + (FAULT != 0 && number[3:0] == 4'd9);
  end
endmodule
