// A light at a crossing, in SystemVerilog that only Verilator reads: a package that is imported, a
// packed struct, an enum, an interface inside, a concurrent assertion.
package lights;
  typedef enum logic [1:0] {RED, GREEN, AMBER} light_t;
  typedef struct packed {
    light_t     light;
    logic [3:0] left;
  } state_t;
  function automatic state_t begun(light_t light);
    return '{light: light, left: light == AMBER ? 4'd2 : 4'd9};
  endfunction
endpackage

interface button_if;
  logic pressed;
endinterface

module crossing import lights::*; #(parameter FAULT = 0) (
    input  logic   clk, rst, walk,
    output light_t light,
    output logic   stays
);
  button_if button ();
  state_t now;
  assign button.pressed = walk;
  assign light = now.light;
  assign stays = now.left != 0;

  always_ff @(posedge clk)
    if (rst) now <= begun(RED);
    else if (stays) now.left <= now.left - 4'd1;
    else
      unique case (now.light)
        RED: now <= begun(GREEN);
        // Green stays until somebody wants to walk.
        GREEN: if (button.pressed) now <= begun(FAULT != 0 ? RED : AMBER);
        default: now <= begun(RED);
      endcase

  assert property (@(posedge clk) disable iff (rst) now.light != 2'd3);
endmodule
