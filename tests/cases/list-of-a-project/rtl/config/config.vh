`define W 5
