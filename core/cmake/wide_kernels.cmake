# polylap_wide_kernels(<target>): the dense kernels once more for wider vectors, on x86-64; the library picks at run time what the
# machine has. Only these files may be compiled so: see kernels_body.hpp.
include(CheckCXXSourceCompiles)

function(polylap_wide_kernels target)
    set(avx2 -mavx2 -mfma)
    set(avx512 -mavx512f -mfma -mprefer-vector-width=512)
    list(JOIN avx512 " " CMAKE_REQUIRED_FLAGS)
    check_cxx_source_compiles("
        #ifndef __x86_64__
        #error
        #endif
        int main() { return __builtin_cpu_supports(\"avx512f\"); }" POLYLAP_HAS_WIDE_KERNELS)
    if(NOT POLYLAP_HAS_WIDE_KERNELS)
        return()
    endif()
    foreach(set IN ITEMS avx2 avx512)
        set(source "${CMAKE_CURRENT_SOURCE_DIR}/src/solve/dense/kernels_${set}.cpp")
        target_sources(${target} PRIVATE "${source}")
        # Fused multiply-add is half of what the wider sets are for.
        set_source_files_properties("${source}" PROPERTIES COMPILE_OPTIONS "${${set}};-ffp-contract=fast")
    endforeach()
    set_source_files_properties(src/solve/dense/kernels.cpp PROPERTIES COMPILE_DEFINITIONS POLYLAP_WIDE_KERNELS)
endfunction()
