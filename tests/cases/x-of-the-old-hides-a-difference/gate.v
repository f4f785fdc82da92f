module t(input clk, input [7:0] d, input [4:0] wa, ra, input we, output [7:0] y);
reg [7:0] m[0:31]; reg [7:0] q; always @(posedge clk) begin if (we) m[wa]<=d; q<=(we&&wa==ra)?d:m[ra]; end assign y=q;
endmodule
