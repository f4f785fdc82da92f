variant("The address lines of ROM 2 are in reverse order" M=16 N=13)
replace(linear.v [[.address(data[M-1:N]),]] [[.address({data[N], data[N+1], data[N+2]}),]])
