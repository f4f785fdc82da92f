# What stands in a variant's file:
#
#   variant("What is different, in a sentence" M=5 N=2)    and the parameters it is built with
#   replace(NAME.v [[text of rtl/NAME/NAME.v as shipped]]  any number of these, in a line or more
#     [[the text that stands there instead]])
#
#   netlist(ice40)                                         what yosys makes of it, or of generic gates
#
# Configuring stops where a file does not hold the text to be replaced exactly once. Text with ]]
# in it stands between [=[ and ]=].

function(variant what)
  set(VARIANT_WHAT "${what}" PARENT_SCOPE)
  set(VARIANT_PARAMETERS "${ARGN}" PARENT_SCOPE)
endfunction()

function(netlist kind)
  set(VARIANT_NETLIST ${kind} PARENT_SCOPE)
endfunction()

function(replace file shipped instead)
  string(FIND "${text_${file}}" "${shipped}" first)
  string(FIND "${text_${file}}" "${shipped}" last REVERSE)
  if(NOT file IN_LIST files OR shipped STREQUAL "" OR first EQUAL -1)
    set(trouble "does not hold")
  elseif(NOT first EQUAL last)
    set(trouble "holds more than once")
  else()
    string(REPLACE "${shipped}" "${instead}" text "${text_${file}}")
    set(text_${file} "${text}" PARENT_SCOPE)
    return()
  endif()
  set(VARIANT_TROUBLE
    "${spec}: rtl/${DESIGN}/${file} ${trouble} the text to be replaced:\n${shipped}" PARENT_SCOPE)
endfunction()

# The names of a folder's modules in `files`, the text of each in text_<name>.
function(read_shipped folder)
  file(GLOB paths CONFIGURE_DEPENDS ${folder}/*.v)
  set(found)
  foreach(path IN LISTS paths)
    get_filename_component(name ${path} NAME)
    list(APPEND found ${name})
    file(READ ${path} text)
    set(text_${name} "${text}" PARENT_SCOPE)
  endforeach()
  set(files ${found} PARENT_SCOPE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${paths})
endfunction()

# An unchanged file keeps its time, so that nothing is verilated again for nothing.
function(write_if_different path text)
  if(EXISTS ${path})
    file(READ ${path} present)
    if("${present}" STREQUAL "${text}")
      return()
    endif()
  endif()
  file(WRITE ${path} "${text}")
endfunction()
