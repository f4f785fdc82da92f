`define STEPPED(x) ((x) + `WIRES_STEP)
