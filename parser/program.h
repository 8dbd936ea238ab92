// What a script keeps between evaluations: syntax, symbols, and the files that it named.
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

/// A file that was loaded once, or the reason why it could not be.
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
    Symbols symbols{&language_words().symbols};
    const Vocabulary& vocabulary = language_words().vocabulary;
    ast::File main;

    std::map<std::string, LoadedScript> scripts;  ///< included ones, by normal path
    std::map<std::string, Loaded<io::LoadedMesh>> meshes;
    std::map<std::pair<std::string, io::ColorSpace>, Loaded<Image>> images;
    std::map<const io::LoadedMesh*, io::ObjMaterials> mesh_materials;
    /// The pieces of meshes with several materials, one piece per material. The second part of the
    /// key: with normals for smooth shading.
    std::map<std::pair<const Mesh*, bool>, std::vector<std::shared_ptr<const Mesh>>> mesh_pieces;
};

}  // namespace lancer
