module t(input clk, input [7:0] d, input [4:0] wa, ra, input we, output [7:0] y);
reg [7:0] m[0:31]; reg [4:0] a; always @(posedge clk) begin if (we) m[wa]<=d; a<=ra; end assign y=m[a];
endmodule
