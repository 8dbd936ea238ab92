#include "model/source.h"

#include <algorithm>

namespace lancer {
namespace {

/// The end of the line that contains `from`: its LF, CRLF or CR, or the end of the text.
std::size_t line_end(std::string_view text, std::size_t from) {
    return std::min(text.find_first_of("\r\n", from), text.size());
}

}  // namespace

std::uint32_t SourceMap::add(std::string name, std::string text) {
    files_.push_back({std::move(name), std::move(text), {}});
    return static_cast<std::uint32_t>(files_.size() - 1);
}

std::string_view SourceMap::text(const SourceSpan& span) const {
    return std::string_view(files_[span.file].text).substr(span.offset, span.length);
}

SourceMap::Position SourceMap::locate(const SourceSpan& span) const {
    const File& file = files_[span.file];
    if (file.line_starts.empty()) {
        file.line_starts.push_back(0);
        for (std::size_t at = 0; (at = line_end(file.text, at)) < file.text.size();) {
            at += std::string_view(file.text).substr(at).starts_with("\r\n") ? 2 : 1;
            file.line_starts.push_back(static_cast<std::uint32_t>(at));
        }
    }
    const auto after =
        std::upper_bound(file.line_starts.begin(), file.line_starts.end(), span.offset);
    const auto line = static_cast<std::uint32_t>(after - file.line_starts.begin());
    return {line, span.offset - *(after - 1) + 1};
}

std::string_view SourceMap::line_text(const SourceSpan& span) const {
    const std::string_view text = files_[span.file].text;
    const std::size_t begin = span.offset - (locate(span).column - 1);
    return text.substr(begin, line_end(text, begin) - begin);
}

}  // namespace lancer
