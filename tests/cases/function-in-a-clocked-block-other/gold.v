module t #(parameter W=3)(input clk, input [W:0] g, output reg [W:0] y);
function [W:0] gray2bin(input [W:0] g);
    integer i;
    for (i = 0; i <= W; i = i + 1) begin
        gray2bin[i] = ^(g >> i);
    end
endfunction
always @(posedge clk) y <= gray2bin(g);
endmodule
