# What `cosim new` asks of RTL, in the folder that has it: cmake -P with
#
#   READER         the program cosim_rtl, and its first words
#   TOP, CLOCK     as cosim_read_rtl() has them
#   SHAPE          parameters, as of cosim_add_design()
#   FILES, OPTIONS of Verilator; YOSYS, its options for yosys
#   WORK           where the answer is to be: tree, found.txt, verilator.txt, the program that
#                  reads RTL and its options, unread.txt as of cosim_read_netlist(), and error.txt, one line
include(${CMAKE_CURRENT_LIST_DIR}/../dut/rtl.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/../dut/shape.cmake)
set_property(GLOBAL PROPERTY COSIM_RTL_PROGRAM ${READER})
function(message kind)
  if(kind STREQUAL FATAL_ERROR)
    string(JOIN "" text ${ARGN})
    file(WRITE ${WORK}/error.txt "${text}")
  endif()
  _message(${kind} ${ARGN})
endfunction()
# The program itself: the script in front of it takes five times as long as a small design.
find_program(VERILATOR_BIN NAMES verilator_bin verilator HINTS $ENV{VERILATOR_ROOT}/bin)
if(NOT VERILATOR_BIN)
  message(FATAL_ERROR "needs verilator")
endif()
cosim_tree_options(tree)
list(JOIN tree "\n" tree)
file(WRITE ${WORK}/verilator.txt "${VERILATOR_BIN}\n${tree}\n")
cosim_shape(shape new "${SHAPE}")
list(JOIN FILES "\" \"" files)
cosim_read_rtl(rtl new ${TOP} ${CLOCK} ${WORK} FILES ${FILES} OPTIONS ${shape_generics} ${OPTIONS}
  YOSYS "read_verilog -sv -defer ${YOSYS} \"${files}\"; hierarchy -check -top ${TOP}${shape_chparams}")
