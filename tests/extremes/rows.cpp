#include "tests/extremes/rows.h"

#include <ostream>

namespace lancer::extremes {

std::vector<int> ks_from(int least, int most, int step) {
    std::vector<int> ks;
    for (int k = least; k <= most; k += step) ks.push_back(k);
    return ks;
}

std::function<std::optional<int>(int)> none_wrong(int least, int most) {
    return [=](int k) { return k >= least && k <= most ? std::optional(0) : std::nullopt; };
}

void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}

std::vector<Row> all_rows() {
    std::vector<Row> rows;
    for (std::vector<Row> part :
         {rows_of_places(), rows_of_gaps(), rows_of_shapes(), rows_of_light(), rows_of_bodies()})
        rows.insert(rows.end(), part.begin(), part.end());
    return rows;
}

}  // namespace lancer::extremes
