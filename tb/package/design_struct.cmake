# A design whose golden model is a struct: its type at each shape, and its exporter, which writes the
# model as a file for all that reasons on it.
include_guard(GLOBAL)

# Both are to be called by cosim_add_design(), whose variables they use: the first for a shape.
function(cosim_struct_shape)
  set(type "::${D_STRUCT}")
  if(shape_values)
    string(APPEND type "<${shape_values}>")
  endif()
  set(parameters "")
  foreach(word IN LISTS shape_names)
    list(POP_FRONT shape_list value)
    string(APPEND parameters "Parameter{\"${word}\", ${value}}, ")
  endforeach()
  set(file ${CMAKE_CURRENT_BINARY_DIR}/exported/${ID})
  string(APPEND struct_shapes ", ${type}")
  string(APPEND struct_parameters "std::array<Parameter, count>{${parameters}}, ")
  string(APPEND struct_files "\"${file}\", ")
  string(APPEND EXPORTS "  cosim::clocked::write_exported<${type}>(\"${file}\", \"${TITLE}\");\n")
  foreach(text shapes parameters files)
    set(struct_${text} "${struct_${text}}" PARENT_SCOPE)
  endforeach()
  set(EXPORTS "${EXPORTS}" PARENT_SCOPE)
  set(shape_values ${shape_number} PARENT_SCOPE)  # its number in place of its parameters
  list(LENGTH shape_names count)
  set(shape_count ${count} PARENT_SCOPE)
  math(EXPR next "${shape_number} + 1")
  set(shape_number ${next} PARENT_SCOPE)
endfunction()

function(cosim_struct_design)
  string(PREPEND SHAPES
    "}  // namespace cosim\n"
    "#include \"model/clocked/design.h\"\n"
    "namespace ${D_NAMESPACE} {\n"
    "using cosim::Parameter;\n"
    "struct Says {\n"
    "  static constexpr const char* name = \"${NAME}\";\n"
    "  static constexpr std::size_t count = ${shape_count};\n"
    "  static constexpr std::array parameters{${struct_parameters}};\n"
    "  static constexpr std::array files{${struct_files}};\n"
    "};\n"
    "using Design = cosim::clocked::DesignOf<Says${struct_shapes}>;\n"
    "}  // namespace ${D_NAMESPACE}\n"
    "namespace cosim {\n\n")
  set(SHAPES "${SHAPES}" PARENT_SCOPE)
  if(D_UNPROVED)
    return()
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/exported)
  file(MAKE_DIRECTORY ${folder})
  configure_file(${root}/tb/package/named_export_of.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${NAME}_export.cpp @ONLY)
  add_executable(${NAME}_export EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${NAME}_export.cpp)
  target_compile_definitions(${NAME}_export PRIVATE COSIM_SYMBOLIC)
  target_compile_options(${NAME}_export PRIVATE -O1 -g1)  # it says lines of the model
  target_link_libraries(${NAME}_export PRIVATE ${D_LIBRARIES} cosim::core)
  add_custom_command(OUTPUT ${folder}/${NAME}.stamp VERBATIM
    COMMAND ${NAME}_export COMMAND ${CMAKE_COMMAND} -E touch ${folder}/${NAME}.stamp
    DEPENDS ${NAME}_export COMMENT "The model of ${NAME} as a file")
  add_custom_target(${NAME}_exported DEPENDS ${folder}/${NAME}.stamp)
  set_property(GLOBAL APPEND PROPERTY COSIM_EXPORTED ${NAME}_exported)
endfunction()
