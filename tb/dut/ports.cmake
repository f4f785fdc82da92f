# The ports of Verilated classes as data, read from what Verilator declares them by. As a script:
#
#   cmake -DOUTPUT=FILE [-DOPEN=CONTROL] -P ports.cmake CLASS.h
#
# writes a header with ports_of(CLASS&), see tb/dut/port_net.h, which enters arrays of several dimensions into
# Verilator's table of names, too; with power_up_again(CLASS&) where all
# state of the class is plain; and where there is a control file, which opens some nets of the class, with
# known_nets<CLASS> of its ports and those nets.
cmake_minimum_required(VERSION 3.25)
include_guard(GLOBAL)
set_property(GLOBAL PROPERTY COSIM_PORTS "${CMAKE_CURRENT_LIST_FILE}")

# cosim_ports(LIBRARY PREFIX...): the header PREFIX_ports.h of each class that verilate() has put into the
# library, in a folder that who links the library can include from. Where PREFIX.vlt is there, it is the
# control file.
function(cosim_ports library)
  get_property(script GLOBAL PROPERTY COSIM_PORTS)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${library}_ports)
  set(verilated ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${library}.dir)
  set(written)
  foreach(prefix IN LISTS ARGN)
    set(control ${CMAKE_CURRENT_BINARY_DIR}/${prefix}.vlt)
    if(NOT EXISTS ${control})
      set(control)
    endif()
    add_custom_command(OUTPUT ${folder}/${prefix}_ports.h
      COMMAND ${CMAKE_COMMAND} -DOUTPUT=${folder}/${prefix}_ports.h -DOPEN=${control} -P ${script}
        ${verilated}/${prefix}.dir/${prefix}.h
      DEPENDS ${script} ${control} ${verilated}/${prefix}.dir/${prefix}.cmake VERBATIM COMMENT "Ports of ${prefix}")
    list(APPEND written ${folder}/${prefix}_ports.h)
  endforeach()
  add_custom_target(${library}_ports DEPENDS ${written})
  add_dependencies(${library} ${library}_ports)
  target_include_directories(${library} SYSTEM PUBLIC ${folder})
endfunction()

# The function of one class.
function(cosim_write_ports header)
  cmake_path(GET header STEM class)
  file(READ ${header} text)
  # VL_IN8(&name,7,0), VL_OUTW(&name,99,0,4), of an array VL_IN8((&name)[4],7,0)
  string(REGEX MATCHALL "VL_(IN|OUT)[0-9W]*[(][^;]*[)]" declared "${text}")
  set(ports "")
  foreach(port IN LISTS declared)
    string(REGEX MATCH
      "^VL_(IN|OUT)[0-9W]*[(][(]*&([A-Za-z0-9_]+)[)]*([^,]*),(-?[0-9]+),(-?[0-9]+)" _ "${port}")
    if(CMAKE_MATCH_1 STREQUAL "IN")
      set(is_input true)
    else()
      set(is_input false)
    endif()
    set(member ${CMAKE_MATCH_2})
    set(array "${CMAKE_MATCH_3}")
    math(EXPR width "${CMAKE_MATCH_4} - ${CMAKE_MATCH_5} + 1")
    set(words 0)
    if(array)
      string(REGEX REPLACE "[]][[]" "*" words "${array}")
      string(REGEX REPLACE "[][]" "" words "${words}")
      math(EXPR words "${words}")
    endif()
    cosim_rtl_name(name ${member})
    string(APPEND ports "      port_net(\"${name}\", ${is_input}, ${width}, ${words}, top.${member}),\n")
  endforeach()
  set(known "")
  if(OPEN)
    cosim_known_nets(known ${header} ${class})
  endif()
  cosim_power_up_again(again ${header} ${class})
  cosim_name_arrays(arrays ${header} ${class})
  set(include)
  if(arrays)
    set(include "#include \"${class}__Syms.h\"\n")
  endif()
  file(WRITE ${OUTPUT} "// Made by ports.cmake.
#pragma once

#include <vector>

#include \"${class}.h\"
#include \"tb/dut/port_net.h\"
${include}${known}${again}
inline std::vector<cosim::PortNet> ports_of(${class}& top) {
  using cosim::port_net;
${arrays}  return {
${ports}  };
}
")
endfunction()

# A name as the RTL writes it: Verilator has another form for words of C++ and for odd characters.
function(cosim_rtl_name variable member)
  string(REGEX REPLACE "^__SYM__" "" name "${member}")
  string(REPLACE "__DOT__" "." name "${name}")
  string(REPLACE "__BRA__" "[" name "${name}")
  string(REPLACE "__KET__" "]" name "${name}")
  while(name MATCHES "__0([0-9A-Fa-f][0-9A-Fa-f])")
    set(coded ${CMAKE_MATCH_0})
    math(EXPR code "0x${CMAKE_MATCH_1}")
    string(ASCII ${code} character)
    string(REPLACE "${coded}" "${character}" name "${name}")
  endwhile()
  string(REGEX REPLACE "([\"\\\\])" "\\\\\\1" name "${name}")
  set(${variable} "${name}" PARENT_SCOPE)
endfunction()

# The text of known_nets: the ports, and the nets that the control file opens, as the class's root has
# them: "CData/*7:0*/ top__DOT__divider__DOT__count;".
function(cosim_known_nets variable header class)
  string(REGEX REPLACE "[.]h$" "___024root.h" root ${header})
  file(READ ${root} text)
  file(READ ${OPEN} open)
  string(REGEX MATCHALL "-var \"[^\"]*\"" open "${open}")
  list(TRANSFORM open REPLACE "^-var \"(.*)\"$" "\\1")
  string(REGEX MATCHALL "VL_(IN|OUT)(8|16|64|)[(][A-Za-z0-9_]+,-?[0-9]+,-?[0-9]+[)]|[CSIQ]Data/[*]-?[0-9]+:-?[0-9]+[*]/ [A-Za-z0-9_]+"
    declared "${text}")
  set(nets "")
  set(count 0)
  foreach(net IN LISTS declared)
    set(is_port false)
    if(net MATCHES "^VL_.*[(](.*),(-?[0-9]+),(-?[0-9]+)[)]$")
      set(member ${CMAKE_MATCH_1})
      math(EXPR width "${CMAKE_MATCH_2} - ${CMAKE_MATCH_3} + 1")
      cosim_rtl_name(name ${member})
      set(is_port true)
    else()
      string(REGEX MATCH "/[*](-?[0-9]+):(-?[0-9]+)[*]/ (.*)$" _ "${net}")
      set(member ${CMAKE_MATCH_3})
      math(EXPR width "${CMAKE_MATCH_1} - ${CMAKE_MATCH_2} + 1")
      cosim_rtl_name(name ${member})
      if(NOT name MATCHES "^[^.]*[.](.*)$")
        continue()
      endif()
      set(name "${CMAKE_MATCH_1}")
      string(REGEX REPLACE "^.*[.]" "" last "${name}")
      if(NOT last IN_LIST open)
        continue()
      endif()
    endif()
    math(EXPR count "${count} + 1")
    string(APPEND nets
      "    {\"${name}\", ${is_port}, ${width}, __builtin_offsetof(${class}___024root, ${member})},\n")
  endforeach()
  set(${variable} "#include \"${class}___024root.h\"

template <>
inline constexpr std::array<cosim::NetOffset, ${count}> cosim::known_nets<${class}>{{
${nets}}};
" PARENT_SCOPE)
endfunction()

# Statements that enter arrays of several dimensions into Verilator's table of names, as an array of all
# elements: Verilator 5.006 writes those as comments, for the table has one dimension.
# "//UNSUP __Vscope_t.varInsert(__Vfinal,"a", &(TOP.t__DOT__a), false, VLVT_UINT8,VLVF_PUB_RW,3 ,3,0 ,0,1 ,0,2);"
function(cosim_name_arrays variable header class)
  cmake_path(GET header PARENT_PATH folder)
  file(GLOB files ${folder}/${class}__Syms*.cpp)
  string(CONCAT array "//UNSUP (__Vscope_[A-Za-z0-9_]+[.]varInsert[(])__Vfinal,(\"[^\"]+\"), &[(]([A-Za-z0-9_.]+)[)], "
    "(false, VLVT_[A-Z0-9]+,[A-Z_|]+),[0-9]+ ([-0-9, ]+)[)]")
  set(text "")
  foreach(file IN LISTS files)
    file(READ ${file} all)
    string(REGEX MATCHALL "${array}" found "${all}")
    foreach(one IN LISTS found)
      string(REGEX MATCH "${array}" _ "${one}")
      set(enter "all.${CMAKE_MATCH_1}1, ${CMAKE_MATCH_2}, &all.${CMAKE_MATCH_3}, ${CMAKE_MATCH_4}, 2")
      set(words "cosim::array_words<decltype(all.${CMAKE_MATCH_3})>")
      string(REGEX REPLACE " *,?(-?[0-9]+),(-?[0-9]+)" " * ((\\1 > \\2 ? \\1 - \\2 : \\2 - \\1) + 1)" bits "${CMAKE_MATCH_5}")
      string(APPEND text "  ${enter}, 1${bits} / ${words} - 1, 0, 0, ${words} - 1);\n")
    endforeach()
  endforeach()
  if(text)
    string(PREPEND text "  ${class}__Syms& all = *top.rootp->vlSymsp;\n")
  endif()
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

# The text of power_up_again: what the constructor and the first eval() do, without the tables of names
# that an instance keeps. Empty where the class has something other than numbers: what brings back a queue
# or a text is not known here.
function(cosim_power_up_again variable header class)
  set(${variable} "" PARENT_SCOPE)
  cmake_path(GET header PARENT_PATH folder)
  file(READ ${folder}/${class}__Syms.h text)
  string(CONCAT all "// INTERNAL STATE\n *${class}[*] const __Vm_modelp;\n( *VlDeleter __Vm_deleter;\n)?"
    " *bool __Vm_didInit = false;\n\n"
    " *// MODULE INSTANCE STATE\n([^/]*)")
  if(NOT text MATCHES "${all}")
    return()
  endif()
  string(REGEX MATCHALL "[A-Za-z0-9_]+ +[A-Za-z0-9_]+" modules "${CMAKE_MATCH_2}")
  set(name "[A-Za-z0-9_]+")
  string(CONCAT plain "VL_(IN|OUT|INOUT)[0-9W]*[(][^\n]*[)]|static constexpr [^\n]*|struct {|}|VlTriggerVec<[0-9]+> ${name}"
    "|(VlUnpacked<)*([CSIQ]Data|VlWide<[0-9]+>|double)(/[*][0-9:]+[*]/)?(, [0-9]+>)* ${name}")
  set(declared "")
  set(calls "")
  foreach(module IN LISTS modules)
    string(REGEX MATCH "^(${name}) +(${name})$" _ "${module}")
    set(type ${CMAKE_MATCH_1})
    string(APPEND declared "void ${type}___ctor_var_reset(${type}* module);\n")
    string(APPEND calls "  ${type}___ctor_var_reset(&all.${CMAKE_MATCH_2});\n")
    file(READ ${folder}/${type}.h text)
    if(NOT text MATCHES "// DESIGN SPECIFIC STATE\n(.*)// INTERNAL VARIABLES\n")
      return()
    endif()
    string(REGEX REPLACE "//[^\n]*" "" state "${CMAKE_MATCH_1}")
    string(REGEX REPLACE "\n *(${plain});?" "\n" state "\n${state}")
    if(NOT state MATCHES "^[ \n]*$")
      return()
    endif()
  endforeach()
  set(${variable} "#include \"${class}__Syms.h\"

${declared}template <>
inline constexpr bool cosim::can_power_up<${class}> = true;
inline void power_up_again(${class}& top) {
  ${class}__Syms& all = *top.rootp->vlSymsp;
  all.__Vm_didInit = false;
${calls}}
" PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  math(EXPR last "${CMAKE_ARGC} - 1")
  cosim_write_ports("${CMAKE_ARGV${last}}")
endif()
