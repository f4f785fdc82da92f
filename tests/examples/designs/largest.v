// The largest of its last four inputs.
module largest #(parameter FAULT = 0) (
    input  wire       clk, rst,
    input  wire [7:0] d,
    output wire [7:0] most
);
  reg [7:0] one, two, three, four;
  wire [7:0] newer = one > two ? one : two;
  wire [7:0] older = three > four && !(FAULT != 0 && three == 8'hff) ? three : four;
  assign most = newer > older ? newer : older;
  always @(posedge clk) {one, two, three, four} <= rst ? 32'd0 : {d, one, two, three};
endmodule
