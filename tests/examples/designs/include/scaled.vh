`define SCALED_STEP_OF(x) ((x) * `SCALED_STEP)
