add_view_test(arc "" ${view} $<TARGET_FILE:cosim> arc --radius 12)
