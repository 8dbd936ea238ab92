#include "reference/pov/resolution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "model/bodies.h"
#include "reference/pov/composites.h"
#include "reference/pov/export_scale.h"
#include "reference/pov/face_moves.h"

namespace lancer::reference::pov {

namespace {

using Resolution = Coincidence::Resolution;

/// The largest number of rounds of raising bodies. A pile of n bodies takes n rounds.
constexpr int most_rounds = 64;

/// How an object or one of its faces can move; it moves by `raised` steps.
struct Mover {
    enum class Way { still, growing, along, face } way = Way::still;
    Vec3d center{0, 0, 0};  ///< growing
    double least = 0;       ///< growing: the reach of the nearest of its faces
    Vec3d normal{0, 0, 0};  ///< along
    double raised = 0;
    bool fixed = false;  ///< was lowered below something that cannot move
};

bool asks_for_nothing(const FacePair& pair) {
    return pair.resolution == Resolution::none || pair.resolution == Resolution::hidden;
}

/// What moves together: an object, a leaf of a composite, or one face of these.
struct Key {
    std::uint32_t object, part, face;
    auto operator<=>(const Key&) const = default;
};
Key key_of(const Face& face) {
    return {face.object, face.part, face.index};
}

class Solver {
  public:
    Solver(const Scene& scene, const std::vector<FacePair>& pairs) : scene_(scene), pairs_(pairs) {
        for (const FacePair& pair : pairs) {
            if (asks_for_nothing(pair)) continue;
            add(pair.front, pair);
            add(pair.back, pair);
        }
        for (auto& [key, mover] : movers_) {
            // A body stays if growth would pull it out of a face, or hardly move that face.
            const auto own = shape_bounds(scene, part_of(scene, key.object, key.part).shape);
            if (mover.way == Mover::Way::growing &&
                !(mover.least >= 0.01 * moved(map_of(key), *own).diagonal()))
                mover.way = Mover::Way::still;
        }
    }

    void solve() {
        if (settle()) return;
        walls_move_ = false;
        for (auto& [key, mover] : movers_) {
            mover.raised = 0;
            mover.fixed = false;
        }
        settle();
    }

    bool holds(const FacePair& pair) const {
        return asks_for_nothing(pair) || lacking(pair) <= 1e-6;
    }

    /// Moves the faces that move one by one. Returns false, and moves none, when nothing would be
    /// left between two of them.
    bool move_faces(Object& object, std::uint32_t index, std::uint32_t part, double step) const {
        const Shape before = object.shape;
        for (auto at = movers_.lower_bound({index, part, 0}); at != movers_.end(); ++at) {
            const auto& [key, mover] = *at;
            if (key.object != index || key.part != part) break;
            if (mover.way != Mover::Way::face) continue;
            std::visit(FaceMove{map_of(key), key.face, mover.raised * step}, object.shape);
        }
        if (std::visit(HasThickness{before}, object.shape)) return true;
        object.shape = before;
        return false;
    }

    /// The object's transform after the movement.
    std::optional<Affine<double>> moved_transform(std::uint32_t index, std::uint32_t part,
                                                  double step) const {
        const Key key{index, part, none};
        const auto found = movers_.find(key);
        if (found == movers_.end() || found->second.raised == 0) return std::nullopt;
        const Mover& mover = found->second;
        Affine<double> way;
        if (mover.way == Mover::Way::along) {
            way.shift = mover.raised * step * mover.normal;
        } else {
            const double growth = mover.raised * step / mover.least;
            for (int i = 0; i < 3; ++i) way.rows[static_cast<std::size_t>(i)][i] += growth;
            way.shift = -growth * mover.center;
        }
        return compose(way, map_of(key));
    }

  private:
    const Affine<double>& map_of(const Key& key) const {
        return scene_.transforms[part_of(scene_, key.object, key.part).transform];
    }

    /// Whether all pairs hold in the end.
    bool settle() {
        for (int round = 0; round < most_rounds; ++round) {
            bool settled = true;
            for (const FacePair& pair : pairs_) settled = holds(pair) && settled;
            if (settled) return true;
            for (const FacePair& pair : pairs_)
                if (!holds(pair)) raise(pair);
        }
        return false;
    }

    void add(const Face& face, const FacePair& pair) {
        const auto [at, is_new] = movers_.try_emplace(key_of(face));
        Mover& mover = at->second;
        if (face.index != none) {
            mover.way = Mover::Way::face;
            return;
        }
        const Shape& shape = part_of(scene_, face.object, face.part).shape;
        const auto own = shape_bounds(scene_, shape);
        if (is_new) {
            mover.way = is_body(scene_, shape) && own ? Mover::Way::growing : Mover::Way::along;
            if (own) mover.center = map_point(map_of(key_of(face)), own->center());
            mover.least = std::numeric_limits<double>::infinity();
        }
        if (mover.way == Mover::Way::growing) {
            mover.least = std::min(mover.least, reach(face, mover.center));
        } else if (mover.way == Mover::Way::along) {
            // A sheet moves away from the body that it lies on.
            const Face& other = key_of(face) == key_of(pair.front) ? pair.back : pair.front;
            const auto* flat = std::get_if<FlatFace>(own ? &other.form : &face.form);
            const bool another =
                !is_new && flat && std::abs(dot(flat->normal, mover.normal)) < 1 - 1e-9;
            if (!flat || another)
                mover.way = Mover::Way::still;
            else
                mover.normal = own && !pair.alike ? -flat->normal : flat->normal;
        }
    }

    /// How far the face moves outwards, in steps, when the object moves by one step.
    double per_step(const Face& face) const {
        const Mover& mover = movers_.at(key_of(face));
        const int outwards = face.turned ? -1 : 1;
        if (mover.way == Mover::Way::growing)
            return outwards * reach(face, mover.center) / mover.least;
        return mover.way == Mover::Way::still ? 0 : outwards;
    }
    double displacement(const Face& face) const {
        return per_step(face) * movers_.at(key_of(face)).raised;
    }

    /// The number of steps that are still missing between the two faces.
    double lacking(const FacePair& pair) const {
        const double back = displacement(pair.back);
        return 1 - (displacement(pair.front) + (pair.alike ? -back : back));
    }

    /// Raises the face that must be in front, or one of two that must overlap. If it cannot move,
    /// the other one yields.
    void raise(const FacePair& pair) {
        Mover& front = movers_.at(key_of(pair.front));
        Mover& back = movers_.at(key_of(pair.back));
        // A cutter must reach out of its body, so it must not shrink as a whole.
        const auto can_move = [this](const Mover& m, const Face& face) {
            const bool may = !face.turned || (walls_move_ && m.way == Mover::Way::face);
            return m.way != Mover::Way::still && !m.fixed && may;
        };
        const double steps = lacking(pair);
        // A wall that sinks into glass is less visible than glass that grows.
        const bool by_wall = !pair.alike && pair.back.turned && can_move(back, pair.back);
        if (can_move(front, pair.front) && !by_wall) {
            front.raised += steps / per_step(pair.front);
        } else if (!can_move(back, pair.back)) {
            return;
        } else if (!pair.alike) {
            back.raised += steps / per_step(pair.back);
        } else {
            back.raised -= steps / per_step(pair.back);
            back.fixed = true;
        }
    }

    const Scene& scene_;
    const std::vector<FacePair>& pairs_;
    std::map<Key, Mover> movers_;
    bool walls_move_ = true;  ///< whether walls of holes may move; tried first
};

/// Groups objects that merged pairs connect.
std::vector<std::vector<std::uint32_t>> groups_of(const std::vector<FacePair>& pairs,
                                                  std::size_t objects) {
    std::vector<std::uint32_t> leader(objects);
    std::iota(leader.begin(), leader.end(), 0U);
    const auto find = [&](std::uint32_t i) {
        while (leader[i] != i) i = leader[i];
        return i;
    };
    for (const FacePair& pair : pairs) {
        if (pair.resolution != Resolution::merged) continue;
        const std::uint32_t a = find(pair.front.object);
        const std::uint32_t b = find(pair.back.object);
        leader[std::max(a, b)] = std::min(a, b);
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
    for (std::uint32_t i = 0; i < objects; ++i) groups[find(i)].push_back(i);
    std::vector<std::vector<std::uint32_t>> out;
    for (auto& [first, members] : groups)
        if (members.size() > 1) out.push_back(std::move(members));
    return out;
}

}  // namespace

ResolvedScene resolved(const Scene& scene, const std::vector<FacePair>& pairs, double step) {
    ResolvedScene result{scene, groups_of(pairs, scene.objects.size()), pairs};
    Solver solver(scene, pairs);
    solver.solve();
    std::vector<Key> too_thin;
    const auto move = [&](Object& object, std::uint32_t index, std::uint32_t part) {
        if (!solver.move_faces(object, index, part, step)) too_thin.push_back({index, part, none});
        const auto transform = solver.moved_transform(index, part, step);
        if (!transform) return;
        object.transform = static_cast<std::uint32_t>(result.scene.transforms.size());
        result.scene.transforms.push_back(*transform);
    };
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        move(result.scene.objects[i], i, none);
        const auto* ref = std::get_if<CompositeRef>(&scene.objects[i].shape);
        if (ref == nullptr) continue;
        std::vector<Composite::Leaf>& leaves = result.scene.composites[ref->composite].leaves;
        for (std::uint32_t k = 0; k < leaves.size(); ++k) move(leaves[k].object, i, k);
    }
    const auto stayed = [&](const Face& face) {
        return std::find(too_thin.begin(), too_thin.end(), Key{face.object, face.part, none}) !=
               too_thin.end();
    };
    for (FacePair& pair : result.pairs) {
        const bool stays = !asks_for_nothing(pair) && (stayed(pair.front) || stayed(pair.back));
        if (stays || !solver.holds(pair)) pair.resolution = Resolution::none;
    }
    return result;
}

}  // namespace lancer::reference::pov
