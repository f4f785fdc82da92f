# cmake -DCOMPILER=... -DSOURCE=... -DSTAMP=... -DINCLUDES=... -DMODEL=... -DFILES=... -DSECONDS=... -P design_export.cmake
#
# Compiles the exporter of a design's golden model and runs it: then FILES.btor2 and more are there, and STAMP,
# with what it depends on in STAMP.d. A model that no exporter can be compiled for is simulated all the
# same: its files have one line "; error: TEXT", which names the line of a header of MODEL, and which
# prove, lanes and all else that reasons on it says.
set(options "")
list(REMOVE_DUPLICATES INCLUDES)
# A library may name the compiler's own folder, which must not come before its others.
list(REMOVE_ITEM INCLUDES "" /usr/include)
foreach(folder IN LISTS INCLUDES)
  list(APPEND options -isystem ${folder})
endforeach()
list(REMOVE_ITEM COMPILER "")
execute_process(
  COMMAND ${COMPILER} -std=c++20 -O1 -g1 -DCOSIM_SYMBOLIC ${options} -w
    -MD -MF ${STAMP}.d -MT ${STAMP} ${SOURCE} -o ${STAMP}.program
  RESULT_VARIABLE status ERROR_VARIABLE said)
set(error "")
if(status EQUAL 0)
  execute_process(COMMAND ${STAMP}.program TIMEOUT ${SECONDS} RESULT_VARIABLE status)
  list(GET MODEL 0 file)
  if(status MATCHES timeout)
    set(error "${file}: the model is not exported within ${SECONDS} s: a loop or recursion in it may not end")
  elseif(NOT status EQUAL 0)
    set(error "${file}: the exporter of the model stops with \"${status}\": a loop or recursion in it may not end")
  endif()
else()
  string(REGEX MATCH "error: ([^\n]*)" error "${said}")
  string(REGEX REPLACE "^static assertion failed( due to requirement [^:]*)?: |^static_assert failed( due to requirement '[^\n]*')? " "" error "${CMAKE_MATCH_1}")
  string(REGEX REPLACE "^\"(.*)\"$" "\\1" error "${error}")  # as Clang has it
  foreach(file IN LISTS MODEL)
    string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" pattern "${file}")
    if(said MATCHES "(${pattern}:[0-9]+):[0-9]+:")
      string(PREPEND error "${CMAKE_MATCH_1}: ")
      break()
    endif()
  endforeach()
endif()
if(error)
  foreach(file IN LISTS FILES)
    foreach(part .btor2 .ways.btor2)
      file(WRITE ${file}${part} "; error: ${error}\n")
    endforeach()
  endforeach()
  if(NOT EXISTS ${STAMP}.d)
    list(JOIN MODEL " " headers)
    file(WRITE ${STAMP}.d "${STAMP}: ${headers}\n")
  endif()
endif()
file(WRITE ${STAMP} "")
