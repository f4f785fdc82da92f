// A shift register with feedback that nothing resets: it begins at its initial value. Its parameters
// are a number, a constant with a width and a text.
module lfsr #(parameter FAULT = 0, parameter [7:0] TAPS = 8'h01, parameter MODE = "HOLD") (
    input  wire       clk, en,
    output wire [7:0] q
);
  reg [7:0] bits = 8'hA5;
  assign q = bits;
  wire [7:0] shifted = {1'b0, bits[7:1]} ^ (bits[0] ? TAPS : 8'h00);
  always @(posedge clk)
    if (en) bits <= shifted ^ {7'b0, FAULT != 0 && bits == 8'h3C};
    else if (MODE == "FILL") bits <= {bits[6:0], 1'b1};
  if (MODE != "FILL" && MODE != "HOLD") begin : g_refused
    no_such_mode refused ();
  end
endmodule
