// The generated section of docs/accuracy.md and its plot:
//     cmake --build build/release --target accuracy_page
#include <fmt/format.h>

#include <string>

#include "model/diagnostic.h"
#include "model/io/file.h"
#include "tests/bench/accuracy/page.h"

int main(int argc, char** argv) {
    using namespace lancer;
    const std::string wanted = argc > 3 ? argv[3] : "";
    if (argc < 3) {
        fmt::print(stderr, "usage: bench_accuracy PAGE.md PLOT.svg [ROWS WHOSE NAMES HOLD THIS]\n");
        return 2;
    }
    std::vector<extremes::Row> rows = extremes::all_rows();
    std::erase_if(
        rows, [&](const extremes::Row& row) { return row.name.find(wanted) == std::string::npos; });
    try {
        const bench::Measurement measured =
            bench::measure(rows, [](const std::string& what) { fmt::print(stderr, "{}\n", what); });
        const std::string section = bench::accuracy_section(measured);
        if (!wanted.empty()) {
            fmt::print("{}", section);  // a part is only shown
            return 0;
        }
        io::write_file(argv[1], bench::with_section(io::read_file(argv[1]), section));
        io::write_file(argv[2], bench::accuracy_plot(measured));
    } catch (const FileError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 4;
    }
}
