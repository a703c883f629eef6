# polylap_wide_kernels(): the dense kernels once more for wider vectors, on x86-64; the library picks at run time what the machine
# has. No other file may be compiled so: see kernels_body.inc.
include(CheckCXXSourceCompiles)

function(polylap_wide_kernels)
    set(CMAKE_REQUIRED_FLAGS "-mavx512f -mfma -mprefer-vector-width=512")
    check_cxx_source_compiles("
        #ifndef __x86_64__
        #error
        #endif
        int main() { return __builtin_cpu_supports(\"avx512f\"); }" POLYLAP_HAS_WIDE_KERNELS)
    if(NOT POLYLAP_HAS_WIDE_KERNELS)
        return()
    endif()
    set(folder src/solve/dense)
    set_source_files_properties(${folder}/kernels.cpp ${folder}/kernels_avx2.cpp ${folder}/kernels_avx512.cpp
        PROPERTIES COMPILE_DEFINITIONS POLYLAP_WIDE_KERNELS)
    # Fused multiply-add is half of what the wider sets are for.
    set_source_files_properties(${folder}/kernels_avx2.cpp
        PROPERTIES COMPILE_OPTIONS "-mavx2;-mfma;-ffp-contract=fast")
    set_source_files_properties(${folder}/kernels_avx512.cpp
        PROPERTIES COMPILE_OPTIONS "-mavx512f;-mfma;-mprefer-vector-width=512;-ffp-contract=fast")
endfunction()
