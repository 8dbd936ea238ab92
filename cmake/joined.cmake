# Compiles several sources as one, so that headers are read once and common templates are compiled
# once. Libraries are joined in the presets `release`, `clang`, `asan` and `coverage` (LANCER_JOIN),
# which are not meant for changing the sources. Gcc's build for developers compiles each source
# separately: it finds sources that forget an include or hide a name, and compiles little after a
# change. Tests are always joined.
option(LANCER_JOIN "Compile several sources of a library as one" OFF)

# lancer_join(TARGET [ALWAYS] [APART WORDS...]): joins in batches, except for sources whose path
# contains one of these words. Their private names occur in other sources, too.
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
