// Any script: no crash, no leak, every message has a place, and a scene without errors satisfies
// the conditions of its structs. Reads no file: names in a script lead to small built-in files.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "parser/parse.h"

namespace {

using namespace lancer;

void require(bool condition) {
    if (!condition) std::abort();
}

Loader small_files() {
    Loader loader;
    loader.text = [](const std::string& path, std::size_t) -> std::string {
        if (path.find("missing") != std::string::npos) throw FileError("no file '" + path + "'");
        if (path.ends_with(".mtl"))
            return "newmtl red\nKd 1 0 0\nmap_Kd a.png\nnewmtl glass\nKs 1 1 1\nd 0.5\nNi "
                   "1.5\nbump\n";
        return "param level = 3 def leaf(at) { sphere { center at radius 1 } } include \"b\"";
    };
    loader.mesh = [](const std::string& path) {
        if (path.find("missing") != std::string::npos) throw FileError("no file '" + path + "'");
        io::LoadedMesh loaded;
        loaded.mesh.vertices = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0)};
        loaded.mesh.uvs = {Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 1)};
        loaded.mesh.faces = {{0, 1, 2}, {2, 1, 0}};
        loaded.face_materials = {0, 1};
        loaded.materials = {"red", "glass"};
        loaded.libraries = {{"both.mtl", 1}};
        return loaded;
    };
    loader.image = [](const std::string& path, io::ColorSpace) {
        if (path.find("missing") != std::string::npos) throw FileError("no file '" + path + "'");
        return Image(1, 1);
    };
    return loader;
}

void check_scene(const Scene& scene) {
    for (const Affine<double>& m : scene.transforms) {
        for (const Vec3d& row : m.rows) require(is_finite(row));
        require(is_finite(m.shift));
    }
    for (const Object& object : scene.objects) {
        require(object.material < scene.materials.size());
        require(object.transform < scene.transforms.size());
        require(object.name == none || object.name < scene.names.size());
        if (const auto* mesh = std::get_if<MeshRef>(&object.shape))
            require(mesh->mesh < scene.meshes.size());
        if (const auto* sphere = std::get_if<Sphere>(&object.shape))
            require(sphere->radius > 0 && std::isfinite(sphere->radius));
    }
    for (const Material& material : scene.materials)
        require(material.texture == none || material.texture < scene.textures.size());
    for (const Camera& camera : scene.cameras) require(camera.position != camera.look_at);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Limits limits;
    // Low limits, so that thousands of inputs per second are tried. A loop that ends at its two
    // hundredth iteration is as good a test as one that ends at its millionth.
    limits.statements = 200;
    limits.list_elements = 1'000;
    limits.objects = 50;
    limits.text_bytes = 4'000;
    limits.calls = 8;
    limits.errors = 10;
    static const Loader files = small_files();
    // Every fourth length has something said by -D, in part wrongly.
    const Definitions definitions =
        size % 4 == 0 ? Definitions{{{"level", "2 + 3"}, {"size", "[1, 2"}}, {}, {}}
                      : Definitions{};
    SourceMap sources;
    std::vector<Diagnostic> found;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const Script script = parse_script("main.lancer", text, limits, sources, found);
    const Evaluation evaluation = evaluate(script, definitions, limits, sources, found, files);
    bool wrong = false;
    for (const Diagnostic& diagnostic : found) {
        wrong |= diagnostic.severity == Severity::error;
        require(!format(diagnostic, sources).empty());
    }
    for (const Diagnostic& diagnostic : evaluation.usage_errors) format(diagnostic, sources);
    if (!wrong) check_scene(evaluation.scene);
    return 0;
}
