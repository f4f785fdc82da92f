// ROM of the major axis (11), the source's Table 2: all ones when selected, else ones at the first
// `address` positions, position 1 the leftmost.
`default_nettype none

module linear_rom11 #(
  parameter integer GAMMA = 3
) (
  input  wire                  chip_select,
  input  wire [GAMMA-1:0]      address,  // register 5
  output wire [(1<<GAMMA)-1:0] word      // positions 1 .. 2^GAMMA
);

  localparam integer WORD = 1 << GAMMA;

  genvar p;
  generate
    for (p = 1; p < WORD; p = p + 1) begin : g_position
      localparam [GAMMA-1:0] POSITION = p;
      assign word[WORD-p] = chip_select | (address >= POSITION);
    end
  endgenerate

  assign word[0] = chip_select;

endmodule

`default_nettype wire
