// Which statements a run reached.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "parser/ast.h"

namespace lancer {

class Executed {
  public:
    void mark(const ast::File& file, std::uint32_t statement) {
        if (marked_ != &file) {
            marked_ = &file;
            marks_ = &of(file);
        }
        (*marks_)[statement] = true;
    }

    /// Marks of the file's statements, by index.
    std::vector<bool>& of(const ast::File& file) {
        std::vector<bool>& marks = files_[&file];
        marks.resize(file.statements.size());
        return marks;
    }

    /// Whether any statement of the file was reached.
    bool holds(const ast::File& file) const { return files_.contains(&file); }

  private:
    std::unordered_map<const ast::File*, std::vector<bool>> files_;
    const ast::File* marked_ = nullptr;  ///< the file that was marked last
    std::vector<bool>* marks_ = nullptr;
};

}  // namespace lancer
