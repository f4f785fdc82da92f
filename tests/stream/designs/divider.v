// A divider with plain start and done, one bit of the quotient a clock. `done` stays high until the
// next start.
module divider #(parameter FAULT = 0) (
    input  wire       clk,
    input  wire       rst,
    input  wire       start,
    input  wire [7:0] dividend,
    input  wire [7:0] divisor,
    output reg        done,
    output reg  [7:0] quotient,
    output reg  [7:0] remainder
);
  reg       works;
  reg [2:0] left;
  wire [8:0] next = {remainder, quotient[7]};
  wire       fits = next >= {1'b0, divisor};
  wire [8:0] less = next - {1'b0, divisor};
  always @(posedge clk)
    if (rst) begin
      works <= 0;
      done  <= 0;
    end else if (start) begin
      works     <= 1;
      done      <= 0;
      left      <= 7;
      quotient  <= dividend;
      remainder <= 0;
    end else if (works) begin
      // The fault: a divisor of 13 is one step short.
      if (left == 0 || (FAULT == 1 && divisor == 13 && left == 1)) begin
        works <= 0;
        done  <= 1;
      end
      left      <= left - 3'd1;
      quotient  <= {quotient[6:0], fits};
      remainder <= fits ? less[7:0] : next[7:0];
    end
endmodule
