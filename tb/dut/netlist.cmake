# What a netlist needs in place of RTL: the file, made by scripts/netlist while CMake configures, as
# verilate() reads its sources then. The parameters are used up in it.
#
#   write_netlist(FILE generic|ice40 DESIGN M=5 N=2)
#
# An unchanged file keeps its time, so that nothing is verilated again for nothing.
function(write_netlist file kind design)
  file(GLOB rtl CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/${design}/*.v)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
    ${rtl} ${PROJECT_SOURCE_DIR}/scripts/netlist ${PROJECT_SOURCE_DIR}/scripts/yosys.sh)
  set(fresh ${file}.fresh)
  get_filename_component(folder ${file} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/netlist --write ${fresh} ${kind} ${design} ${ARGN}
    COMMAND_ERROR_IS_FATAL ANY)
  file(COPY_FILE ${fresh} ${file} ONLY_IF_DIFFERENT)
  file(REMOVE ${fresh})
endfunction()
