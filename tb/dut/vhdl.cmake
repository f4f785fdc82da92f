# VHDL among the sources of a design.
include_guard(GLOBAL)
set_property(GLOBAL PROPERTY COSIM_VHDL_READER "${CMAKE_CURRENT_LIST_DIR}/vhdl.pl")

# cosim_verilog_of(VARIABLE WHAT TOP FOLDER SHAPE FILE...): the files, with those of VHDL as one of
# Verilog, which is written into FOLDER for the shape "W=8 MODE=FAST". An error, one line that begins with
# WHAT, where GHDL is missing or cannot do it.
function(cosim_verilog_of variable what top folder shape)
  set(vhdl ${ARGN})
  list(FILTER vhdl INCLUDE REGEX "[.]vhdl?$")
  set(verilog ${ARGN})
  if(vhdl)
    list(FILTER verilog EXCLUDE REGEX "[.]vhdl?$")
    list(APPEND verilog ${folder}/vhdl.v)
    separate_arguments(values UNIX_COMMAND "${shape}")
    get_property(reader GLOBAL PROPERTY COSIM_VHDL_READER)
    find_program(COSIM_PERL perl REQUIRED)
    file(MAKE_DIRECTORY ${folder})
    execute_process(COMMAND ${COSIM_PERL} ${reader} ${top} ${folder}/vhdl.v ${values} ${vhdl}
      RESULT_VARIABLE status ERROR_VARIABLE error)
    if(status)
      string(STRIP "${error}" error)
      message(FATAL_ERROR "${what}: ${error}")
    endif()
    if(NOT CMAKE_SCRIPT_MODE_FILE)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${vhdl} ${reader})
    endif()
  endif()
  set(${variable} ${verilog} PARENT_SCOPE)
endfunction()
