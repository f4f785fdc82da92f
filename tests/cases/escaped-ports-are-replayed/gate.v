module t(input clk, rst, input \a.b[0] , input [31:2] addr, output reg [31:2] \next.pc );
  always @(posedge clk)
    if (rst) \next.pc <= 0;
    else \next.pc <= addr - \a.b[0] ;
endmodule
