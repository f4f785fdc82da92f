variant("The iCE40 netlist of yosys" W=6)

netlist(ice40)
