# polylap_header_only(<target> <header> <what to link> <Debian package>)
#
# Lets <target> include a header-only library. The header (or its directory) is linked into the build tree and found there, because
# the usual place, /usr/include, must not become an include path of a cross compiler: it holds the host's libc.
function(polylap_header_only target header entry package)
    string(MAKE_C_IDENTIFIER "POLYLAP_${package}_INCLUDE_DIR" variable)
    find_path(${variable} "${header}" PATHS /usr/include /usr/local/include /opt/homebrew/include NO_CMAKE_FIND_ROOT_PATH
              DOC "Directory that holds ${header}")
    mark_as_advanced(${variable})
    if(NOT ${variable})
        message(FATAL_ERROR "polylap needs the header ${header}: install the Debian package ${package}, or set ${variable}.")
    endif()
    set(view "${CMAKE_CURRENT_BINARY_DIR}/header_only")
    file(MAKE_DIRECTORY "${view}")
    file(CREATE_LINK "${${variable}}/${entry}" "${view}/${entry}" COPY_ON_ERROR SYMBOLIC)
    target_include_directories(${target} SYSTEM PRIVATE "${view}")
endfunction()
