// Part files: written strip by strip, read row by row.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "model/io/part_layout.h"

namespace lancer::io {

/// Writes a part atomically; holds at most one strip at a time. `draw` returns the strips in turn,
/// in linear light, with the width and the channels of the head. Throws FileError, and what `draw`
/// throws.
void write_part(const std::string& path, const PartHead& head,
                const std::function<Image(const Strip&)>& draw);

/// Reads the rows of a part from the top. The file is open only while a strip is read, because a
/// picture may have more parts than a process may have open files.
class PartReader {
  public:
    /// Throws FileError when the file cannot be read, is not a part, or differs from such a part in
    /// size or head.
    explicit PartReader(const std::string& path);
    ~PartReader();
    PartReader(const PartReader&) = delete;
    PartReader& operator=(const PartReader&) = delete;

    const PartHead& head() const;
    const std::string& path() const;
    /// Reads the next row into as many doubles as it has values. Throws FileError when it is
    /// damaged.
    void read_row(double* pixels);
    /// To be called after the last row. Throws FileError when the digest of the rows read is wrong.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Reads a whole part. Throws FileError when it is damaged or not a part.
PartHead checked_part(const std::string& path);

}  // namespace lancer::io
