#include "parser/rules.h"

namespace lancer::rules {

bool Net::read(const Value& value, std::vector<std::vector<Vec3d>>& out, std::string& instead) {
    return read_list(value, out, instead, [](const Value& row, std::vector<Vec3d>& points) {
        std::string ignored;
        return Points::read(row, points, ignored);
    });
}

bool Faces::read(const Value& value, std::vector<std::vector<std::uint32_t>>& out,
                 std::string& instead) {
    return read_list(value, out, instead,
                     [](const Value& face, std::vector<std::uint32_t>& corners) {
                         std::string ignored;
                         const auto one = [](const Value& v, std::uint32_t& index) {
                             if (!v.is_number() || !(v.number() >= 0 && v.number() < none) ||
                                 v.number() != std::floor(v.number()))
                                 return false;
                             index = static_cast<std::uint32_t>(v.number());
                             return true;
                         };
                         return read_list(face, corners, ignored, one) && corners.size() >= 3;
                     });
}

}  // namespace lancer::rules
