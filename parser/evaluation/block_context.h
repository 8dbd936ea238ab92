// What the reading of blocks works with.
#pragma once

#include "parser/evaluation/context.h"

namespace lancer {

class Expressions;
class Files;
class Names;
class SceneBuilder;
class Singles;

/// Beside the context of the whole evaluation: who gives values and files, and what is built.
struct BlockContext : Context {
    Expressions& expressions;
    const Names& names;
    Files& files;
    SceneBuilder& builder;
    Singles& singles;
};

}  // namespace lancer
