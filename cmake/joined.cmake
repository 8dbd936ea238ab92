# Several sources compiled as one: headers are read once, and the templates that they use alike are made and optimised
# once. Libraries are joined in the presets that build for something else than changing the sources (LANCER_JOIN):
# `release`, `clang`, `asan`, `coverage`. Gcc's build for developers compiles each of them by itself, and so finds the one
# that forgets to include what it uses or that hides a name; and after a change it compiles little. Tests are always joined.
option(LANCER_JOIN "Compile several sources of a library as one" OFF)

# lancer_join(TARGET [ALWAYS] [APART WORDS...]): in batches, but for the sources with one of these words in their path, which
# have private names that others have, too.
function(lancer_join target)
    cmake_parse_arguments(PARSE_ARGV 1 join "ALWAYS" "" "APART")
    if(NOT LANCER_JOIN AND NOT join_ALWAYS)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    get_target_property(sources ${target} SOURCES)
    foreach(word IN LISTS join_APART)
        set(apart ${sources})
        list(FILTER apart INCLUDE REGEX "${word}.*\\.cpp$")
        set_source_files_properties(${apart} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endforeach()
endfunction()
