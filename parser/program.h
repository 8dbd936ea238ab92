// What is kept of a script between its evaluations: syntax, symbols, and the files it named.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/io/obj_materials.h"
#include "parser/ast.h"
#include "parser/parse.h"
#include "parser/symbols.h"
#include "parser/vocabulary.h"

namespace lancer {

/// A file that was loaded once, or why it could not be.
template <class Content>
struct Loaded {
    std::shared_ptr<const Content> content;
    std::string problem;
};

struct LoadedScript {
    std::unique_ptr<ast::File> file;
    std::string problem;
    std::uint64_t bytes = 0;
};

struct Program {
    Symbols symbols = language_words().symbols;
    const Vocabulary& vocabulary = language_words().vocabulary;
    ast::File main;

    std::map<std::string, LoadedScript> scripts;  ///< included ones, by normal path
    std::map<std::string, Loaded<io::LoadedMesh>> meshes;
    std::map<std::pair<std::string, io::ColorSpace>, Loaded<Image>> images;
    std::map<const io::LoadedMesh*, io::ObjMaterials> mesh_materials;
    /// Meshes with several materials, one for each of them; second: with normals for smoothness.
    std::map<std::pair<const Mesh*, bool>, std::vector<std::shared_ptr<const Mesh>>> mesh_pieces;
};

}  // namespace lancer
