module t(input clk, input a, en, e2, output [29:0] o, output [1:0] l);
 reg [31:2] d; reg [1:0] lsb;
 always @(posedge clk) begin if (en) d <= {a,d[31:3]}; if (e2) lsb <= {d[2],lsb[1]}; end
 assign o=d; assign l=lsb;
endmodule
