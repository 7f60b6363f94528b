# Libraries that are loaded on first use (tracer/system/shared_library.h): a room sees their headers
# and their name, and is not linked with them.

# durer_loaded_library(room NAME library): defines DURER_<NAME>_LIBRARY, a string, in the room's sources.
function(durer_loaded_library room name library)
  if(TARGET ${library})
    target_include_directories(durer_${room} SYSTEM PRIVATE
      $<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>)
    get_target_property(file ${library} LOCATION)
  else()
    find_library(${name}_LOADED_LIBRARY ${library} REQUIRED)
    set(file ${${name}_LOADED_LIBRARY})
  endif()
  execute_process(COMMAND ${CMAKE_OBJDUMP} -p ${file} OUTPUT_VARIABLE headers COMMAND_ERROR_IS_FATAL ANY)
  if(NOT headers MATCHES "SONAME +([^\n ]+)")
    message(FATAL_ERROR "${file} has no soname")
  endif()
  target_compile_definitions(durer_${room} PRIVATE DURER_${name}_LIBRARY="${CMAKE_MATCH_1}")
endfunction()
