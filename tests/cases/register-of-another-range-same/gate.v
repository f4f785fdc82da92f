module t(input clk, input a, en, e2, output [29:0] o, output [1:0] l);
 reg [31:0] d;
 always @(posedge clk) begin if (en) d[31:2] <= {a,d[31:3]}; if (e2) d[1:0] <= {d[2],d[1]}; end
 assign o=d[31:2]; assign l=d[1:0];
endmodule
