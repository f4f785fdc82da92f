module t(input clk,rst,input [7:0] a,b,input [3:0] c,output reg [15:0] y);
wire [7:0] w=a[3:0]*2, v=a[3:0]*11,z=a[3:0]*4;
reg [15:0] k; always @(posedge clk) if(rst) k<=0; else k<=k+1;
always @(posedge clk) if(rst) y<=0; else y<=k^(w+(v<<2)+(z<<4));
endmodule
