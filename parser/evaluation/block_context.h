// The context in which blocks are read.
#pragma once

#include "parser/evaluation/context.h"

namespace lancer {

class Expressions;
class Files;
class Names;
class SceneBuilder;
class Singles;

/// Adds to the context of the evaluation: where values and files come from, and the scene that is
/// being built.
struct BlockContext : Context {
    Expressions& expressions;
    const Names& names;
    Files& files;
    SceneBuilder& builder;
    Singles& singles;
};

}  // namespace lancer
