# polylap_compile_options(<target>): what all of polylap's own sources are compiled with. Nothing of it reaches consumers.
function(polylap_compile_options target)
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4 /fp:precise /permissive- /utf-8)
        return()
    endif()
    target_compile_options(${target} PRIVATE
        -ffp-contract=off  # The same numbers natively and in WebAssembly, which has no fused multiply-add.
        -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
        # GCC 12 misreads std::string's operator+ (its bug 105651).
        $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    )
endfunction()
