`ifndef CHECKS
`define CHECKS
`define ERROR(text) \
  $error("%0t: %s", $time, text)
`define CHECK(name, condition, clock, reset) \
  name: assert property (@(posedge clock) disable iff (reset) (condition)) \
    else begin \
      `ERROR(`"name`"); \
    end
`define CHECK_NOW(name, condition) \
  name: assert (condition) \
    else `ERROR(`"name`");
`endif
