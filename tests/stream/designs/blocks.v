// Folds a block of 100 bits, given on one clock, into 50. The fault: one block bit is not folded.
module blocks #(parameter FAULT = 0) (
    input  wire        clk, rst,
    input  wire        go,
    input  wire [99:0] block,
    input  wire [69:0] key,
    output reg  [69:0] seen,  // the last block, its upper bits
    output reg         digest_valid,
    output reg  [49:0] digest
);
  always @(posedge clk) begin
    digest_valid <= go && !rst;
    digest <= block[99:50] ^ block[49:0] ^ key[69:20] ^ (FAULT != 0 && block[70:64] == 7'd5 ? 50'd1 : 50'd0);
    seen <= block[99:30];
  end
endmodule
