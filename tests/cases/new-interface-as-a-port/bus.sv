package bus_pkg;
  typedef enum logic [1:0] { IDLE, READ, WRITE } kind_t;
  typedef struct packed { logic [3:0] tag; kind_t kind; } info_t;
endpackage
interface bus #(parameter int W = 8, parameter type T = logic) (input logic clk, input logic en);
  localparam int twice = 2 * W;
  typedef logic [twice-1:0] wide_t;
  logic [W-1:0] a;
  wide_t b;
  logic c [2];
  T t;
  bus_pkg::kind_t kind;
  bus_pkg::info_t info;
  logic signed [3:0] level;
  logic valid, unused;
  modport target(input clk, a, c, t, kind, info, valid, output b, level);
  modport source(output a, valid, kind, input b);
endinterface
