`define WAITS
