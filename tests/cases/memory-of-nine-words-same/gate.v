module t(input clk, we, input [8:0] a, input [3:0] d, output reg [3:0] q);
  reg [3:0] mem [0:8];
  wire inside_mem = a < 9;
  always @(posedge clk) begin
    if (we && inside_mem) mem[a[3:0]] <= d;
    q <= inside_mem ? mem[a[3:0]] : 4'd5;
  end
endmodule
