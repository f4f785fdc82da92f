typedef struct packed {logic v; logic [3:0] d;} item_t;
module t #(parameter N = 3) (input logic clk, input logic rst, input logic [3:0] a [N], input item_t s [1:0][4],
         output logic [3:0] y [N-1:0], output logic one [2], output item_t q [1:0][4]);
  always_ff @(posedge clk) begin
    for (int i = 0; i < N; i++) y[i] <= rst ? '0 : a[i] + 4'(i);
    q <= s;
  end
  assign one[0] = y[0] == 0, one[1] = y[1] == 0;
endmodule
