variant("A code is taken on the clock that takes BP" M=5 N=2)
replace(linear_control.v [[load_uk = idle & write_uk & ~write_bp;]] [[load_uk = idle & write_uk;]])
