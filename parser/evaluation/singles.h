// What may stand once in a scene: where it was met first.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "parser/report.h"

namespace lancer {

/// Reports a second statement of a kind that may stand once; `first` remembers the first.
bool is_repeated(std::string_view word, SourceSpan& first, const SourceSpan& place, Report& report);

class Singles {
  public:
    explicit Singles(Report& report) : report_(report) {}

    /// Reports a second one of its kind.
    bool is_second_image(const SourceSpan& place) { return is_second("image", image_, place); }
    bool is_second_render(const SourceSpan& place) { return is_second("render", render_, place); }
    bool is_second_ambient(const SourceSpan& place) {
        return is_second("ambient", ambient_, place);
    }
    /// The same; background and sky stand for one thing.
    bool is_second_background(const SourceSpan& place);
    bool is_second_sky(const SourceSpan& place);
    /// Reports a second camera of a name.
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
