# The sources of a design as the Verilog that all tools are given.
include_guard(GLOBAL)
set_property(GLOBAL PROPERTY COSIM_VHDL_READER "${CMAKE_CURRENT_LIST_DIR}/vhdl.pl")
include(${CMAKE_CURRENT_LIST_DIR}/../rtl/tool.cmake)

# cosim_verilog_of(VARIABLE WHAT TOP FOLDER SHAPE "NAME,..." FILE...): the files, with those of VHDL as
# one of Verilog, and in place of those with instances of the blackboxes NAME or with inout ports copies
# (tb/rtl/plain_verilog.h), written into FOLDER for the shape "W=8 MODE=FAST". An error is one line that begins
# with WHAT.
function(cosim_verilog_of variable what top folder shape blackboxes)
  set(vhdl ${ARGN})
  list(FILTER vhdl INCLUDE REGEX "[.]vhdl?$")
  set(verilog ${ARGN})
  find_program(COSIM_PERL perl REQUIRED)
  file(MAKE_DIRECTORY ${folder})
  if(vhdl)
    list(FILTER verilog EXCLUDE REGEX "[.]vhdl?$")
    list(APPEND verilog ${folder}/vhdl.v)
    separate_arguments(values UNIX_COMMAND "${shape}")
    get_property(reader GLOBAL PROPERTY COSIM_VHDL_READER)
    execute_process(COMMAND ${COSIM_PERL} ${reader} ${top} ${folder}/vhdl.v ${values} ${vhdl}
      RESULT_VARIABLE status ERROR_VARIABLE error)
    cosim_read_again("${what}" ${status} "${error}" ${reader} ${vhdl})
  endif()
  cosim_rtl_program(program)
  execute_process(COMMAND ${program} verilog ${top} ${folder} "${blackboxes}" ${verilog}
    RESULT_VARIABLE status ERROR_VARIABLE error OUTPUT_VARIABLE read)
  cosim_read_again("${what}" ${status} "${error}" ${verilog})
  string(REGEX MATCHALL "[^\n]+" verilog "${read}")
  set(${variable} ${verilog} PARENT_SCOPE)
endfunction()

# Ends with the error of a program where its status is one; else has CMake run again where its files change.
function(cosim_read_again what status error)
  if(status)
    string(STRIP "${error}" error)
    message(FATAL_ERROR "${what}: ${error}")
  endif()
  if(NOT CMAKE_SCRIPT_MODE_FILE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
  endif()
endfunction()
