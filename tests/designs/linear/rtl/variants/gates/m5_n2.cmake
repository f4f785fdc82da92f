variant("The iCE40 netlist of yosys" M=5 N=2)

netlist(ice40)
