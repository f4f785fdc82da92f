// Counts the clocks on which `en` is set, and says when the next one begins anew.
module counter #(parameter W = 8) (
    input  wire         clk,
    input  wire         rst,
    input  wire         en,
    output wire [W-1:0] count,
    output wire         last
);
  reg [W-1:0] total;
  assign count = total;
  assign last  = &total;
  always @(posedge clk) total <= rst ? {W{1'b0}} : total + {{W-1{1'b0}}, en};
endmodule
