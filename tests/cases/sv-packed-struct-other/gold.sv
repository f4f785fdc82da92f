// The first member of a packed struct is at the top.
module t(input [7:0] a, output [7:0] y);
  typedef struct packed {
    logic [2:0] op;
    logic signed [3:0] value;
    logic valid;
  } item_t;
  item_t i;
  assign i = a;
  assign y = i.valid ? {i.op, 5'd0} : i.value;
endmodule
