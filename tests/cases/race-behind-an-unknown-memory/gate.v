module t(input c, input [1:0] a, input [3:0] d, output reg [3:0] q); reg [3:0] m[0:3]; always @(posedge c) begin q <= m[a]; m[a] <= d; end endmodule
