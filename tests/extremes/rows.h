// Scenes that a number k makes extreme, and the requirements on their pictures: for the tests, and
// for the table of docs/accuracy.md, which also renders them with other programs.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "model/image.h"
#include "model/scene.h"

namespace lancer::extremes {

struct Row {
    std::string name;     ///< one line of a table, Markdown; says what k is
    std::vector<int> ks;  ///< ascending
    std::function<Scene(int k)> scene;

    // What the picture of scene(k) is compared with; exactly one of the four.
    std::function<Scene(int k)> same_as;     ///< this scene, rendered by the same program
    std::function<Scene(int k)> exactly_as;  ///< this scene, rendered by Lancer in 113 bits
    std::optional<Color> uniform;            ///< this colour everywhere
    std::function<Image(int k)> formula;

    bool steady = false;     ///< `exactly_as` is one scene for all k
    bool unordered = false;  ///< a larger k is no harder
    bool bits = false;       ///< every bit counts, not only differences above 1/255
    /// How many wrong pixels the project's aims allow at k; nothing when there is no aim.
    std::function<std::optional<int>(int k)> allowed;
    std::string asked;     ///< the same in words
    bool povray = true;    ///< POV-Ray has the same meaning for all of it
    bool tachyon = false;  ///< Tachyon has what it takes: balls, boxes, cylinders, triangles
    bool plotted = false;
};

/// `least`, `least` + step … `most`.
std::vector<int> ks_from(int least, int most, int step = 1);
/// No wrong pixel from `least` to `most`.
std::function<std::optional<int>(int)> none_wrong(int least, int most);

/// For messages of failed tests.
void PrintTo(const Row& row, std::ostream* out);

// Grouped by what is extreme.
std::vector<Row> rows_of_places();  ///< size, position, distance, groups
std::vector<Row> rows_of_gaps();    ///< thin things, small gaps and none
std::vector<Row> rows_of_shapes();  ///< rods, apices, needles, leaks
std::vector<Row> rows_of_light();   ///< grazing, strong, sharp; glass
std::vector<Row> rows_of_bodies();  ///< joined, intersected, cut
std::vector<Row> all_rows();

}  // namespace lancer::extremes
