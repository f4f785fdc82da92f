// Every D-th clock since the last restart.
module uart_divider #(parameter D = 4) (
    input  wire clock,
    input  wire restart,
    output wire tick
);
  reg [7:0] count;
  localparam [31:0] LAST = D - 1;
  assign tick = count == LAST[7:0];
  always @(posedge clock) count <= restart | tick ? 8'd0 : count + 8'd1;
endmodule
