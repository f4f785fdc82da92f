# A write to register 3 changes register 1.
s/pwrite && paddr\[3:2\] == 2'd1/pwrite \&\& paddr[2]/
