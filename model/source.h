// Places in scripts, and how messages show them.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace lancer {

/// A range of bytes in one source file. It has twelve bytes, so every object of a scene can store
/// one.
struct SourceSpan {
    static constexpr std::uint32_t nowhere = 0xFFFFFFFF;
    std::uint32_t file = nowhere;  ///< index into SourceMap; `nowhere`: not from a script
    std::uint32_t offset = 0;      ///< bytes from the start of the file
    std::uint32_t length = 0;      ///< bytes

    bool operator==(const SourceSpan&) const = default;
};

/// Owns the name and the text of every file that was read. Texts never move after they were added.
class SourceMap {
  public:
    std::uint32_t add(std::string name, std::string text);
    std::size_t size() const { return files_.size(); }
    const std::string& name(std::uint32_t file) const { return files_[file].name; }
    std::string_view text(std::uint32_t file) const { return files_[file].text; }
    std::string_view text(const SourceSpan& span) const;

    struct Position {
        std::uint32_t line = 0;    ///< from 1
        std::uint32_t column = 0;  ///< from 1, in bytes
    };
    Position locate(const SourceSpan& span) const;
    /// The line on which the span starts, without its end (LF, CRLF or CR).
    std::string_view line_text(const SourceSpan& span) const;

  private:
    struct File {
        std::string name;
        std::string text;
        mutable std::vector<std::uint32_t> line_starts;  ///< filled at the first locate()
    };
    std::deque<File> files_;
};

}  // namespace lancer
