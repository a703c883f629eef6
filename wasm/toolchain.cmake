# Finds Emscripten's own toolchain file: emsdk, a package (em-config on the PATH), or Debian's place.
set(candidates "$ENV{EMSDK}/upstream/emscripten" "$ENV{EMSCRIPTEN}")
find_program(POLYLAP_EM_CONFIG em-config NO_CMAKE_FIND_ROOT_PATH)
mark_as_advanced(POLYLAP_EM_CONFIG)
if(POLYLAP_EM_CONFIG)
    execute_process(COMMAND "${POLYLAP_EM_CONFIG}" EMSCRIPTEN_ROOT OUTPUT_VARIABLE root OUTPUT_STRIP_TRAILING_WHITESPACE)
    list(APPEND candidates "${root}")
endif()
list(APPEND candidates /usr/share/emscripten)

set(POLYLAP_EMSCRIPTEN_FILE "")
foreach(root IN LISTS candidates)
    if(root AND EXISTS "${root}/cmake/Modules/Platform/Emscripten.cmake")
        set(POLYLAP_EMSCRIPTEN_FILE "${root}/cmake/Modules/Platform/Emscripten.cmake")
        break()
    endif()
endforeach()
if(NOT POLYLAP_EMSCRIPTEN_FILE)
    message(FATAL_ERROR "Emscripten was not found: install the Debian package emscripten, or activate an emsdk (EMSDK is not set).")
endif()

# Emscripten searches its sysroot only; Eigen's package is header-only and serves every target.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
include("${POLYLAP_EMSCRIPTEN_FILE}")
# Not -msse4.1 for Eigen's own packets: measured, it makes nothing faster, assembly 4 % slower, and 37 kB more.
set(CMAKE_CXX_FLAGS_INIT -msimd128)
list(APPEND CMAKE_PREFIX_PATH /usr /usr/local /opt/homebrew)

# The emulator that emcmake would set passes flags that recent Node refuses.
set(CMAKE_CROSSCOMPILING_EMULATOR node)
