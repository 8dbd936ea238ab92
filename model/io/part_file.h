// Parts of a picture as files: written strip by strip, read row by row.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "model/io/part_layout.h"

namespace lancer::io {

/// Writes a part atomically, without ever holding more than one strip. `draw` gives the strips in
/// turn, in linear light, of the width and the channels that the head tells. Throws FileError, and
/// what `draw` throws.
void write_part(const std::string& path, const PartHead& head,
                const std::function<Image(const Strip&)>& draw);

/// A part whose rows are read from the top. The file is open only while a strip of it is read: a
/// picture may have more parts than a process may have open files.
class PartReader {
  public:
    /// Throws FileError when the file cannot be read, is no part, or has not the size and the head
    /// that such a part has.
    explicit PartReader(const std::string& path);
    ~PartReader();
    PartReader(const PartReader&) = delete;
    PartReader& operator=(const PartReader&) = delete;

    const PartHead& head() const;
    const std::string& path() const;
    /// The next row, as many doubles as it has values. Throws FileError when it is damaged.
    void read_row(double* pixels);
    /// To be called after the last row: throws FileError when the digest is not that of what has
    /// been read.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Reads all of a part. Throws FileError when it is none, or damaged.
PartHead checked_part(const std::string& path);

}  // namespace lancer::io
