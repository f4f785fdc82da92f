// Which of the blocks comes first is not defined; the memory begins as x.
module t(input c, input [1:0] a, input [3:0] d, output reg [3:0] q); reg [3:0] m[0:3]; always @(posedge c) m[a] = d; always @(posedge c) q <= m[a]; 
endmodule
