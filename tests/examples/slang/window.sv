package kinds;
  typedef enum logic [1:0] {IDLE, RUN, DONE} state_e;
  typedef struct packed {logic valid; logic [6:0] data;} item_t;
endpackage
module window import kinds::*; #(parameter int N = 4)(input logic clk, rst_n, input item_t in, output item_t out, output logic [3:0] n);
  state_e state;
  item_t held [2];
  for (genvar i = 0; i < 2; ++i) begin : g
    always_ff @(posedge clk or negedge rst_n)
      if (!rst_n) held[i] <= '{default: '0};
      else if (in.valid) held[i] <= (i == 0) ? in : held[0];
  end
  always_ff @(posedge clk or negedge rst_n) begin
    if (!rst_n) begin state <= IDLE; n <= '0; end
    else begin
      unique case (state) inside
        IDLE: if (in.valid) state <= RUN;
        RUN: begin n <= n + 1; if (n == N'(3)) state <= DONE; end
        default: state <= IDLE;
      endcase
    end
  end
  assign out = held[1];
  assert property (@(posedge clk) disable iff (!rst_n) $past(state) == RUN |-> state != IDLE || 1);
endmodule
