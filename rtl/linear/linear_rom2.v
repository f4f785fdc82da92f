// ROM of the control code (2), the source's Table 1: position p of the word, p = 1 the leftmost, is
// bit A_i of the address (A_1 the high one) where p = 2^(i - 1) * (2k - 1).
`default_nettype none

module linear_rom2 #(
  parameter integer GAMMA = 3
) (
  input  wire [GAMMA-1:0]      address,  // the GAMMA high bits of UK
  output wire [(1<<GAMMA)-2:0] word      // positions 1 .. 2^GAMMA - 1
);

  localparam integer WORD = 1 << GAMMA;

  genvar i;
  genvar k;
  generate
    for (i = 1; i <= GAMMA; i = i + 1) begin : g_address_bit
      for (k = 1; k <= (1 << (GAMMA - i)); k = k + 1) begin : g_position
        assign word[WORD-1-(1<<(i-1))*(2*k-1)] = address[GAMMA-i];
      end
    end
  endgenerate

endmodule

`default_nettype wire
