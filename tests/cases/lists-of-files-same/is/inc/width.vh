`define W 4
