// Measures the time and memory for reading a mesh of a million triangles: writes it as OBJ, PLY and
// STL into a folder and reads each in a process of its own.
//
//     bench_mesh [FOLDER [TRIANGLES]]
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "model/diagnostic.h"
#include "model/io/file.h"
#include "model/io/mesh_file.h"

namespace {

using namespace lancer;

/// A waved square of about this many triangles, with a normal for each vertex.
Mesh waves(int triangles) {
    Mesh mesh;
    const int side = std::max(1, static_cast<int>(std::sqrt(triangles / 2.0)));
    for (int j = 0; j <= side; ++j) {
        for (int i = 0; i <= side; ++i) {
            const double x = 2.0 * i / side - 1;
            const double y = 2.0 * j / side - 1;
            mesh.vertices.emplace_back(x, y, x * x * y / 3 + y * x);
            mesh.normals.push_back(normalize(Vec3d(-2 * x * y / 3 - y, -x * x / 3 - x, 1)));
        }
    }
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const std::uint32_t a = static_cast<std::uint32_t>(j * (side + 1) + i);
            const std::uint32_t d = a + static_cast<std::uint32_t>(side) + 1;
            mesh.faces.push_back({a, a + 1, d + 1});
            mesh.faces.push_back({a, d + 1, d});
        }
    }
    return mesh;
}

std::string obj_text(const Mesh& mesh) {
    std::string text;
    char line[200];
    const auto add = [&](int length) { text.append(line, static_cast<std::size_t>(length)); };
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3d& v = mesh.vertices[i];
        const Vec3d& n = mesh.normals[i];
        add(std::snprintf(line, sizeof line, "v %.12f %.12f %.12f\nvn %.8f %.8f %.8f\n", v.x, v.y,
                          v.z, n.x, n.y, n.z));
    }
    for (const auto& [a, b, c] : mesh.faces) {
        add(std::snprintf(line, sizeof line, "f %u//%u %u//%u %u//%u\n", a + 1, a + 1, b + 1, b + 1,
                          c + 1, c + 1));
    }
    return text;
}

template <class Value>
void append(std::string& bytes, Value value) {  // little-endian machines only
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string ply_bytes(const Mesh& mesh) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                        std::to_string(mesh.vertices.size()) +
                        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                        std::to_string(mesh.faces.size()) +
                        "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3d& v : mesh.vertices) {
        for (const double x : {v.x, v.y, v.z}) append(bytes, static_cast<float>(x));
    }
    for (const auto& face : mesh.faces) {
        append(bytes, std::uint8_t{3});
        for (const std::uint32_t corner : face) append(bytes, corner);
    }
    return bytes;
}

std::string stl_bytes(const Mesh& mesh) {
    std::string bytes(80, ' ');
    append(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
    for (const auto& face : mesh.faces) {
        bytes.append(12, '\0');
        for (const std::uint32_t corner : face) {
            const Vec3d& v = mesh.vertices[corner];
            for (const double x : {v.x, v.y, v.z}) append(bytes, static_cast<float>(x));
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

/// Runs `action` in a child process and prints its time and peak memory. The child is started
/// before anything large is in memory.
void measure(const std::string& label, const std::function<void()>& action) {
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child == 0) {
        action();
        _exit(0);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%-44s %6.2f s %6.0f MB%s\n", label.c_str(), seconds,
                static_cast<double>(usage.ru_maxrss) / 1024, status == 0 ? "" : "  FAILED");
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string folder = argc > 1 ? argv[1] : std::filesystem::temp_directory_path().string();
    const int triangles = argc > 2 ? std::atoi(argv[2]) : 1000000;
    const struct {
        const char* ending;
        std::string (*make)(const Mesh&);
    } formats[] = {{"obj", obj_text}, {"ply", ply_bytes}, {"stl", stl_bytes}};
    for (const auto& [ending, make] : formats) {
        const std::string path = folder + "/lancer-bench." + ending;
        measure(std::string("write ") + ending,
                [&, make = make] { io::write_file(path, make(waves(triangles))); });
        std::error_code error;
        const double megabytes = static_cast<double>(std::filesystem::file_size(path, error)) / 1e6;
        measure(std::string("read  ") + ending + ", " + std::to_string(megabytes) + " MB", [&] {
            try {
                const Mesh mesh = io::read_mesh(path).mesh;
                if (mesh.faces.empty()) std::abort();
            } catch (const FileError&) {
                std::abort();
            }
        });
        std::filesystem::remove(path, error);
    }
}
