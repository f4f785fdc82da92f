# A design whose golden model is a struct: its type at each shape, and its exporter, which writes the
# model as a file for all that reasons on it.
include_guard(GLOBAL)

# All are to be called by cosim_add_design(), whose variables they use: the second for a shape. Sets
# D_STRUCT, design_namespace, which gets the Design of the struct, and has_clock: whether it is a model of
# every clock. One of streams alone is UNPROVED.
function(cosim_struct)
  if(NOT model_text MATCHES "#include <cosim/(model|stream)[.]h>")
    message(FATAL_ERROR "${what}: MODEL: no header has #include <cosim/model.h> or <cosim/stream.h>")
  endif()
  set(has_clock TRUE PARENT_SCOPE)
  string(REGEX REPLACE "//[^\n]*" "" code "${model_text}")
  if(code MATCHES "#include <cosim/stream[.]h>" AND NOT code MATCHES "[^.A-Za-z0-9_]clock *[(]")
    set(has_clock FALSE PARENT_SCOPE)
    set(D_UNPROVED TRUE PARENT_SCOPE)
  endif()
  if(NOT D_STRUCT)
    string(REPLACE "_" ";" words ${NAME})
    foreach(word IN LISTS words)
      string(SUBSTRING "${word}" 0 1 letter)
      string(SUBSTRING "${word}" 1 -1 word)
      string(TOUPPER "${letter}" letter)
      string(APPEND D_STRUCT "${letter}${word}")
    endforeach()
  endif()
  string(REGEX REPLACE "^.*::" "" last "${D_STRUCT}")
  if(NOT code MATCHES "[^A-Za-z0-9_]${last}[^A-Za-z0-9_]|#include \"")
    message(FATAL_ERROR "${what}: MODEL: has no struct ${D_STRUCT}; STRUCT names another")
  endif()
  set(head "(struct|class) +${last} *[:{\n]")
  if(code MATCHES "template *<[^;{]*${head}")
    if(D_SHAPES STREQUAL " ")
      message(FATAL_ERROR "${what}: ${D_STRUCT} is a template: SHAPES gives its parameters")
    endif()
  elseif(code MATCHES "${head}" AND NOT D_SHAPES STREQUAL " ")
    message(FATAL_ERROR "${what}: ${D_STRUCT} is no template, but SHAPES gives it parameters")
  endif()
  set(D_STRUCT ${D_STRUCT} PARENT_SCOPE)
  set(design_namespace cosim::struct_${NAME} PARENT_SCOPE)
endfunction()

# Adds what cosim_shape() has found of a shape, whose model is exported to a file of that name.
macro(cosim_struct_add name title)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/exported/${name})
  set(type "::${D_STRUCT}")
  if(NOT "${shape_values}" STREQUAL "")
    string(APPEND type "<${shape_values}>")
  endif()
  set(parameters "")
  foreach(word IN LISTS shape_names)
    list(POP_FRONT shape_list value)
    string(APPEND parameters "Parameter{\"${word}\", ${value}}, ")
  endforeach()
  string(APPEND struct_shapes ", ${type}")
  string(APPEND struct_parameters "std::array<Parameter, count>{${parameters}}, ")
  string(APPEND struct_files "\"${file}\", ")
  list(APPEND struct_paths ${file})
  string(APPEND EXPORTS "  cosim::clocked::write_exported<${type}>(\"${file}\", \"${title}\");\n")
endmacro()

function(cosim_struct_shape)
  cosim_struct_add(${ID} "${TITLE}")
  foreach(text shapes parameters files paths)
    set(struct_${text} "${struct_${text}}" PARENT_SCOPE)
  endforeach()
  set(EXPORTS "${EXPORTS}" PARENT_SCOPE)
  set(trait_model "  using Model = ${type};\n" PARENT_SCOPE)
  set(shape_values ${shape_number} PARENT_SCOPE)  # its number in place of its parameters
  list(LENGTH shape_names count)
  set(shape_count ${count} PARENT_SCOPE)
  math(EXPR next "${shape_number} + 1")
  set(shape_number ${next} PARENT_SCOPE)
endfunction()

function(cosim_struct_design)
  if(has_clock)
    set(header model/clocked/design.h)
    set(design DesignOf)
  else()
    set(header model/core/fields.h)
    set(design StreamDesign)
  endif()
  foreach(shape IN LISTS D_MODEL_SHAPES)
    cosim_shape(shape "${what}" "${shape}")
    cosim_struct_add(${NAME}_${shape_number} "${NAME} ${shape_title}")
    math(EXPR shape_number "${shape_number} + 1")
  endforeach()
  string(PREPEND SHAPES
    "}  // namespace cosim\n"
    "#include \"${header}\"\n"
    "namespace ${design_namespace} {\n"
    "using cosim::Parameter;\n"
    "struct Says {\n"
    "  static constexpr const char* name = \"${NAME}\";\n"
    "  static constexpr std::size_t count = ${shape_count};\n"
    "  static constexpr std::array<std::array<Parameter, count>, ${shape_number}> parameters{{\n"
    "    ${struct_parameters}}};\n"
    "  static constexpr std::array files{${struct_files}};\n"
    "};\n"
    "using Design = cosim::clocked::${design}<Says${struct_shapes}>;\n"
    "}  // namespace ${design_namespace}\n"
    "namespace cosim {\n\n")
  set(SHAPES "${SHAPES}" PARENT_SCOPE)
  if(NOT has_clock)
    return()
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/exported)
  file(MAKE_DIRECTORY ${folder})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${NAME}_export.cpp)
  configure_file(${root}/tb/package/named_export_of.cpp.in ${source} @ONLY)
  set(stamp ${folder}/${NAME}.stamp)
  list(TRANSFORM D_LIBRARIES REPLACE "(.+)" "$<TARGET_PROPERTY:\\1,INTERFACE_INCLUDE_DIRECTORIES>"
    OUTPUT_VARIABLE includes)
  add_custom_command(OUTPUT ${stamp} DEPFILE ${stamp}.d VERBATIM
    COMMAND ${CMAKE_COMMAND} "-DCOMPILER=${CMAKE_CXX_COMPILER_LAUNCHER};${CMAKE_CXX_COMPILER}"
      -DSOURCE=${source} -DSTAMP=${stamp} "-DMODEL=${model}" "-DFILES=${struct_paths}"
      "-DINCLUDES=$<TARGET_PROPERTY:cosim::core,INTERFACE_INCLUDE_DIRECTORIES>;${includes}"
      -DSECONDS=300 -P ${root}/tb/package/design_export.cmake
    DEPENDS ${source} ${root}/tb/package/design_export.cmake COMMENT "The model of ${NAME} as a file")
  add_custom_target(${NAME}_exported DEPENDS ${stamp})
  set_property(GLOBAL APPEND PROPERTY COSIM_EXPORTED ${NAME}_exported)
endfunction()
