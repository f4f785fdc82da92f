variant("The iCE40 netlist of yosys" W=4)

netlist(ice40)
