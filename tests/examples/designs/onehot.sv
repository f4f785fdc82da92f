// A ring of one bit that goes round, against a model that has the number of its place.
module onehot #(parameter FAULT = 0) (
    input  wire       clk, rst, go,
    output wire [2:0] place,
    output wire       last
);
  reg [4:0] ring;
  assign place = {ring[4], ring[3] | ring[2], ring[3] | ring[1]};
  assign last  = ring[4];
  always @(posedge clk)
    if (rst) ring <= 5'd1;
    else if (go) ring <= FAULT != 0 && ring[3] ? 5'd1 : {ring[3:0], ring[4]};
  always @(posedge clk) if (!rst) assert (ring != 5'd0);
endmodule
