#include "cli/picture_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <string>

#include "cli/arguments.h"
#include "cli/session.h"
#include "model/io/picture_process.h"

namespace lancer::cli {

void add_picture_options(CLI::App& app) {
    const auto limits = std::make_shared<io::PictureLimits>();
    const auto add = [&](const std::string& name, std::uint64_t io::PictureLimits::*member,
                         std::int64_t most, const std::string& what) {
        app.add_option_function<std::string>(
               name,
               [limits, name, member, most](const std::string& text) {
                   const std::int64_t value = parse_whole_number(text);
                   if (value < 1 || value > most)
                       throw UsageError(fmt::format("{} must be between 1 and {}", name, most));
                   (*limits).*member = static_cast<std::uint64_t>(value);
                   io::set_picture_limits(*limits);
               },
               fmt::format("{} (default {})", what, (*limits).*member))
            ->type_name("N")
            ->group("Limits");
    };
    add("--limit-picture-memory", &io::PictureLimits::memory, 1 << 20,
        "Memory for decoding a picture file, in MiB");
    add("--limit-picture-seconds", &io::PictureLimits::seconds, 1'000'000,
        "Processor seconds for a picture file, plus one second for each MiB");
}

void add_encoding_options(CLI::App& app, io::ImageWriteOptions& image) {
    const char* group = "Output";
    app.add_option_function<std::string>(
           "--bits",
           [&image](const std::string& text) {
               if (text != "8" && text != "16") throw UsageError("--bits must be 8 or 16");
               image.bits = text == "8" ? 8 : 16;
           },
           "Bits per channel of PNG, TIFF and PPM; by default 8")
        ->type_name("8|16")
        ->group(group);
    app.add_flag("--linear", image.linear, "Write linear values instead of the sRGB curve")
        ->group(group);
}

}  // namespace lancer::cli
