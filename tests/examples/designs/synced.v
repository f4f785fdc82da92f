// A counter whose reset comes by two flip-flops: it is to be held for three clocks.
module synced #(parameter FAULT = 0) (
    input  wire       clk, reset, en,
    output wire [2:0] q
);
  reg       first, second;
  reg [2:0] count;
  assign q = count;
  always @(posedge clk) begin
    first  <= reset;
    second <= first;
    if (second) count <= 3'd0;
    else if (en) count <= count + (FAULT != 0 && count == 3'd5 ? 3'd2 : 3'd1);
  end
endmodule
