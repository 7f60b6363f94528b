# One target per room of the house (design.md 2). A room's sources are all .cpp files of its folder;
# its dependencies are the rooms it may include, and check_rooms.py fails the build on any other.

find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_custom_target(check_rooms ALL
  COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/cmake/check_rooms.py ${CMAKE_SOURCE_DIR}
  COMMENT "Checking that rooms include only what they may" VERBATIM)

# The standard library and GLM are nine tenths of what a source includes: the math room compiles them
# for all rooms.
set(DURER_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <functional> <limits> <memory> <mutex>
    <optional> <stdexcept> <string> <string_view> <unordered_map> <utility> <variant> <vector>
    <glm/common.hpp> <glm/geometric.hpp> <glm/vec2.hpp> <glm/vec3.hpp> <glm/vec4.hpp>)
# Rooms that rays pass through are optimised as one when the command is linked (7 % less CPU); the tests
# link their plain objects.
set(DURER_HOT_ROOMS math patterns functions shapes texture intersect world lights cameras volumes
    shading sampling)

# durer_room(NAME folder DEPENDS rooms... LIBRARIES imported targets...)
function(durer_room name folder)
  cmake_parse_arguments(ROOM "" "" "DEPENDS;LIBRARIES;EXCLUDE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
  foreach(pattern ${ROOM_EXCLUDE})
    list(FILTER sources EXCLUDE REGEX ${pattern})
  endforeach()
  if(sources)
    add_library(durer_${name} STATIC ${sources})
    target_link_libraries(durer_${name} PUBLIC durer_flags PRIVATE ${ROOM_LIBRARIES})
    foreach(room ${ROOM_DEPENDS})
      target_link_libraries(durer_${name} PUBLIC durer_${room})
    endforeach()
    add_dependencies(durer_${name} check_rooms)
    if(DURER_LTO AND name IN_LIST DURER_HOT_ROOMS)
      target_compile_options(durer_${name} PRIVATE -flto -ffat-lto-objects)
    endif()
    if(name STREQUAL math)
      target_precompile_headers(durer_math PRIVATE ${DURER_COMMON_HEADERS})
    else()
      target_precompile_headers(durer_${name} REUSE_FROM durer_math)
    endif()
  else()
    add_library(durer_${name} INTERFACE)
    target_link_libraries(durer_${name} INTERFACE durer_flags ${ROOM_LIBRARIES})
    foreach(room ${ROOM_DEPENDS})
      target_link_libraries(durer_${name} INTERFACE durer_${room})
    endforeach()
  endif()
endfunction()
