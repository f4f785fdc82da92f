variant("As shipped, for comparison" W=6)
