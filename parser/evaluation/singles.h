// What a scene may contain only once: remembers the place of the first.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "parser/report.h"

namespace lancer {

/// True for a second statement of a kind that may stand once, which is reported. `first` holds the
/// place of the first.
bool is_repeated(std::string_view word, SourceSpan& first, const SourceSpan& place, Report& report);

class Singles {
  public:
    explicit Singles(Report& report) : report_(report) {}

    /// True for a second block of its kind, which is reported.
    bool is_second_image(const SourceSpan& place) { return is_second("image", image_, place); }
    bool is_second_render(const SourceSpan& place) { return is_second("render", render_, place); }
    bool is_second_ambient(const SourceSpan& place) {
        return is_second("ambient", ambient_, place);
    }
    /// The same. Background and sky exclude each other.
    bool is_second_background(const SourceSpan& place);
    bool is_second_sky(const SourceSpan& place);
    /// False for a second camera with the same name, which is reported.
    bool is_new_camera(const std::string& name, const SourceSpan& place);

  private:
    bool is_second(std::string_view word, SourceSpan& first, const SourceSpan& place) {
        return is_repeated(word, first, place, report_);
    }
    void refuse_beside(const SourceSpan& other, const SourceSpan& place);

    Report& report_;
    SourceSpan image_, render_, background_, ambient_, sky_;
    std::unordered_map<std::string, SourceSpan> cameras_;
};

}  // namespace lancer
