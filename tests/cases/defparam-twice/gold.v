module s #(parameter A=1)(input [3:0] a,output [7:0] o); assign o=a*A; endmodule
module t(input clk,rst,input [7:0] a,b,input [3:0] c,output reg [15:0] y);
wire [7:0] w[0:2]; genvar g; generate for(g=0;g<3;g=g+1) begin:q s #(.A(9)) u(a[3:0],w[g]); defparam u.A=g+2; end endgenerate defparam q[1].u.A=11;
reg [15:0] k; always @(posedge clk) if(rst) k<=0; else k<=k+1;
always @(posedge clk) if(rst) y<=0; else y<=k^(w[0]+(w[1]<<2)+(w[2]<<4));
endmodule
