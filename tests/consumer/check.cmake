# Installs polylap, moves the installation elsewhere (it must not remember its place), builds consumer.cpp against it and reads what
# the program prints. Variables: WAY (find_package or pkg_config), BUILD_DIR, CXX, CXX_FLAGS, EIGEN_DIR.
set(scratch "${BUILD_DIR}/consumer/${WAY}")
set(prefix "${scratch}/moved")
file(REMOVE_RECURSE "${scratch}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${scratch}/prefix"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${scratch}/prefix" "${prefix}")

if(WAY STREQUAL "find_package")
    execute_process(COMMAND "${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${scratch}/build" -G Ninja
                            "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
                            "-DEigen3_DIR=${EIGEN_DIR}"
                    COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND "${CMAKE_COMMAND}" --build "${scratch}/build" COMMAND_ERROR_IS_FATAL ANY)
    set(program "${scratch}/build/consumer")
else()
    file(GLOB_RECURSE pc "${prefix}/polylap.pc")
    cmake_path(GET pc PARENT_PATH directory)
    set(ENV{PKG_CONFIG_PATH} "${directory}")
    execute_process(COMMAND pkg-config --cflags --libs polylap OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE
                    COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    separate_arguments(CXX_FLAGS UNIX_COMMAND "${CXX_FLAGS}")
    set(program "${scratch}/consumer")
    execute_process(COMMAND "${CXX}" -std=c++20 ${CXX_FLAGS} "${CMAKE_CURRENT_LIST_DIR}/consumer.cpp" ${flags} -o "${program}"
                    COMMAND_ERROR_IS_FATAL ANY)
endif()

execute_process(COMMAND "${program}" OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
# Zero at the corners and one at the edge midpoints of 2×2 unit squares: 4λ/(1+2λ) with λ = 1, and the five-point star.
foreach(line "alexa-wardetzky 1.33333" "planar 1")
    string(FIND "\n${printed}" "\n${line}\n" found)
    if(found EQUAL -1)
        message(FATAL_ERROR "expected a line '${line}', but the program printed:\n${printed}")
    endif()
endforeach()
