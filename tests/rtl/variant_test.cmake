# replace() of variant.cmake: cmake -DCASE=<case> -P variant_test.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/variant.cmake)

set(DESIGN uart)
set(spec variants/uart/faults/example.cmake)
set(files a.v)
set(text_b.v "  assign a = b[0];\n") # of another design
set(text_a.v [[
  assign a = b[0];
  assign c = d;
  assign c = d;
]])

if(CASE STREQUAL "once")
  replace(a.v [[
  assign a = b[0];
]] [[
  assign a = ~b[0]; // "so"; ${not} \n a variable
]])
  set(expected [[
  assign a = ~b[0]; // "so"; ${not} \n a variable
  assign c = d;
  assign c = d;
]])
  if(NOT "${text_a.v}" STREQUAL "${expected}")
    message(FATAL_ERROR "${text_a.v}")
  endif()
elseif(CASE STREQUAL "missing")
  replace(a.v "  assign a = b[1];\n" "")
elseif(CASE STREQUAL "twice")
  replace(a.v "  assign c = d;\n" "")
elseif(CASE STREQUAL "no_file")
  replace(b.v "  assign a = b[0];\n" "")
else()
  message(FATAL_ERROR "no case ${CASE}")
endif()
message("${VARIANT_TROUBLE}")
