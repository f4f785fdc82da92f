module t(input clk,rst,input [7:0] a,b,input [3:0] c,output reg [15:0] y);
logic [7:0] n,m; function f(input [7:0] i); begin n=n+1; f=(i>8'h80); end endfunction
always @(posedge clk) begin if(rst) n=0; else begin if (a==8'h77 && b==8'h55) assert (n++ < 300); end m<=n; end
reg [15:0] k; always @(posedge clk) if(rst) k<=0; else k<=k+1;
always @(posedge clk) if(rst) y<=0; else y<=k^(m);
endmodule
