# What every target of the project is built with.
add_library(solitaire_options INTERFACE)
target_include_directories(solitaire_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(solitaire_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Werror)
# g++ 12 sees overlapping copies in "text" + std::string (GCC bug 105651).
target_compile_options(solitaire_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(SOLITAIRE_SANITIZE)
  set(solitaire_sanitizers address,undefined)
  if(SOLITAIRE_SANITIZE STREQUAL thread)
    set(solitaire_sanitizers thread)
  endif()
  target_compile_options(solitaire_options INTERFACE -fsanitize=${solitaire_sanitizers} -fno-sanitize-recover=all
                                                     -fno-omit-frame-pointer)
  target_link_options(solitaire_options INTERFACE -fsanitize=${solitaire_sanitizers})
endif()
if(SOLITAIRE_FUZZ)
  target_compile_options(solitaire_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# For what runs for a shorter time than it takes to compile with sanitizers.
add_library(sanitized_as_it_is INTERFACE)
target_compile_options(sanitized_as_it_is INTERFACE $<$<BOOL:${SOLITAIRE_SANITIZE}>:-O0>)

# solitaire_library(NAME DEPENDENCY...): a library of all the .cpp files of the current folder and those below it. A
# folder below with a CMakeLists.txt of its own is a module that this library does not contain.
function(solitaire_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  file(GLOB modules CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*/CMakeLists.txt)
  foreach(module ${modules})
    get_filename_component(folder ${module} DIRECTORY)
    list(FILTER sources EXCLUDE REGEX "^${folder}/")
  endforeach()
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC solitaire_options ${ARGN})
endfunction()

# solitaire_fuzzer(SOURCE DEPENDENCY...): SOURCE.cpp, named from the current folder, as a libFuzzer program of the name of the
# file, if those are built. bin/fuzz finds it in fuzz/.
function(solitaire_fuzzer source)
  if(SOLITAIRE_FUZZ)
    get_filename_component(name ${source} NAME)
    add_executable(${name} ${source}.cpp)
    target_link_libraries(${name} PRIVATE solitaire_options ${ARGN} -fsanitize=fuzzer)
    set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/fuzz)
  endif()
endfunction()
