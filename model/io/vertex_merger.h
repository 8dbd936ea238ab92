// Merges all vertices at the same place into one index.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "model/math.h"
#include "model/shapes.h"

namespace lancer::io {

/// Appends a vertex to a list unless the list has one with exactly the same coordinates (0 and -0
/// are equal). A hash table with open addressing, at most half full.
class VertexMerger {
  public:
    explicit VertexMerger(std::vector<Vec3d>& vertices) : vertices_(vertices), table_(16, none) {}

    std::uint32_t index_of(const Vec3d& vertex) {
        if (2 * (vertices_.size() + 1) > table_.size()) grow();
        std::uint32_t& slot = find(vertex);
        if (slot == none) {
            slot = static_cast<std::uint32_t>(vertices_.size());
            vertices_.push_back(vertex);
        }
        return slot;
    }

  private:
    static std::uint64_t hash(const Vec3d& v) {
        std::uint64_t sum = 0;
        for (const double x : {v.x, v.y, v.z}) {
            // The finalizer of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014). Adding 0 converts
            // -0 to 0.
            sum += std::bit_cast<std::uint64_t>(x + 0.0) + 0x9E3779B97F4A7C15;
            sum = (sum ^ (sum >> 30)) * 0xBF58476D1CE4E5B9;
            sum = (sum ^ (sum >> 27)) * 0x94D049BB133111EB;
            sum ^= sum >> 31;
        }
        return sum;
    }

    /// The slot of an equal vertex, or the free slot for this vertex.
    std::uint32_t& find(const Vec3d& vertex) {
        std::size_t slot = static_cast<std::size_t>(hash(vertex)) & (table_.size() - 1);
        while (table_[slot] != none && vertices_[table_[slot]] != vertex) {
            slot = (slot + 1) & (table_.size() - 1);
        }
        return table_[slot];
    }

    void grow() {
        table_.assign(2 * table_.size(), none);
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            find(vertices_[i]) = static_cast<std::uint32_t>(i);
        }
    }

    std::vector<Vec3d>& vertices_;
    std::vector<std::uint32_t> table_;  ///< a power of two of slots: an index or `none`
};

}  // namespace lancer::io
