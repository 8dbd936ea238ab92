#include "model/io/mtl_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "model/io/text_scanner.h"

namespace lancer::io {
namespace {

std::string_view trimmed(std::string_view text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; };
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
}

class MtlReader {
  public:
    MtlReader(std::string_view bytes, const std::string& name)
        : scanner_(without_mark(bytes), name, '#', '\\') {}

    MtlFile read() {
        while (!scanner_.at_end()) {
            const std::string keyword(scanner_.word());
            if (keyword == "newmtl") {
                file_.materials.emplace_back().name = std::string(trimmed(scanner_.rest_of_line()));
            } else if (file_.materials.empty()) {
                throw scanner_.error(fmt::format("'newmtl' expected, not '{}'", quotable(keyword)));
            } else {
                statement(keyword, file_.materials.back());
            }
        }
        return std::move(file_);
    }

  private:
    static std::string_view without_mark(std::string_view bytes) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        return bytes.starts_with(byte_order_mark) ? bytes.substr(byte_order_mark.size()) : bytes;
    }

    /// Reads a statement up to the end of its line.
    void statement(const std::string& keyword, MtlMaterial& material) {
        if (keyword == "map_Kd") {
            image(material);
            return;
        }
        if (keyword == "Kd") {
            color(keyword, material.diffuse);
        } else if (keyword == "Ka") {
            color(keyword, material.ambient);
        } else if (keyword == "Ks") {
            color(keyword, material.specular);
        } else if (keyword == "Ke") {
            color(keyword, material.emission);
        } else if (keyword == "Ns") {
            material.shininess = std::max(scanner_.number("an exponent"), 0.0);
        } else if (keyword == "Ni") {
            const double ior = scanner_.number("an index of refraction");
            if (ior > 0) material.ior = ior;
        } else if (keyword == "d") {
            opacity(material);
        } else if (keyword == "Tr") {
            material.opacity = 1 - share("a transparency");
        } else if (keyword == "illum") {
            const double model = scanner_.number("an illumination model");
            if (model >= 0 && model <= 10) {
                material.illumination = static_cast<int>(model);
            } else {
                skip("illum");
            }
        } else {
            skip(quotable(keyword));
        }
        scanner_.next_line();
    }

    double share(const char* what) { return std::clamp(scanner_.number(what), 0.0, 1.0); }

    void opacity(MtlMaterial& material) {
        if (scanner_.next_word_begins('-') &&
            !scanner_.next_is_number()) {  // -halo depends on the angle of view
            skip("d " + quotable(scanner_.word()));
        }
        material.opacity = share("an opacity");
    }

    /// Three numbers, or one for all three; spectral curves and CIE colours are skipped.
    void color(const std::string& keyword, std::optional<Color>& target) {
        if (scanner_.next_word_begins('s') || scanner_.next_word_begins('x')) {
            skip(keyword + " " + quotable(scanner_.word()));
            return;
        }
        const char* what = "a part of a colour";
        const double red = std::max(scanner_.number(what), 0.0);
        if (scanner_.at_line_end()) {
            target = Color(red);
            return;
        }
        const double green = std::max(scanner_.number(what), 0.0);
        const double blue = std::max(scanner_.number(what), 0.0);
        target = Color(red, green, blue);
    }

    /// `map_Kd [-option value ...] name with blanks.png`
    void image(MtlMaterial& material) {
        while (scanner_.next_word_begins('-')) {
            const std::string option(scanner_.word());
            skip("map_Kd " + quotable(option));
            // -o, -s and -t take up to three numbers, -mm two; the other options take a word.
            if (option == "-o" || option == "-s" || option == "-t" || option == "-mm") {
                while (scanner_.next_is_number()) scanner_.any_number("a number");
            } else {
                scanner_.word();
            }
        }
        material.image = std::string(trimmed(scanner_.rest_of_line()));
        std::replace(material.image.begin(), material.image.end(), '\\', '/');
    }

    void skip(const std::string& what) {
        if (seen_.insert(what).second)
            file_.skipped.push_back(fmt::format("{} (line {})", what, scanner_.line()));
    }

    TextScanner scanner_;
    MtlFile file_;
    std::set<std::string> seen_;
};

}  // namespace

MtlFile read_mtl(std::string_view bytes, const std::string& name) {
    return MtlReader(bytes, name).read();
}

}  // namespace lancer::io
