variant("A negative rate steps where there is a carry" W=6)
replace(dda_axis.v [[down = may_step & ~carry & rate[W];]] [[down = may_step & carry & rate[W];]])
