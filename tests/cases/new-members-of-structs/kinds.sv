package kinds;
  typedef enum logic [1:0] {idle, run, done} state_e;
  typedef struct packed {logic [2:0] tag; logic signed [3:0] data;} item_t;
endpackage
module t import kinds::*; (input logic clk, rst, input item_t d, output item_t q, output state_e now);
  state_e state;
  logic [1:0][3:0] store[2][3];
  always_ff @(posedge clk) begin
    store[d.tag[2]][d.tag[1:0]] <= 8'(d.data);
    q <= rst ? 7'h1f : 7'(store[d.tag[0]][d.tag[2:1]]);
    if (rst) state <= run;
    else state <= state == done ? idle : state_e'(state + 1);
  end
  assign now = state;
endmodule
