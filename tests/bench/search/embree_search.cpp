#include "tests/bench/search/search_rays.h"

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>

#include <cmath>
#include <memory>
#endif

namespace lancer::search {

#if __has_include(<embree3/rtcore.h>)

namespace {

/// A mesh in Embree's own tree.
class Prepared {
  public:
    Prepared(const Mesh& mesh, bool robust)
        : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                    3 * sizeof(float), mesh.vertices.size()));
        for (const Vec3d& v : mesh.vertices)
            for (int a = 0; a < 3; ++a) *vertices++ = static_cast<float>(v[a]);
        auto* faces = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                    3 * sizeof(std::uint32_t), mesh.faces.size()));
        for (const Mesh::Corners& face : mesh.faces)
            for (const std::uint32_t corner : face) *faces++ = corner;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~Prepared() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;

    void one_by_one(std::span<const SearchRay> rays, std::span<double> distances,
                    std::span<std::uint32_t> faces) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRayHit ray{};
            ray.ray.org_x = static_cast<float>(rays[i].origin.x);
            ray.ray.org_y = static_cast<float>(rays[i].origin.y);
            ray.ray.org_z = static_cast<float>(rays[i].origin.z);
            ray.ray.dir_x = static_cast<float>(rays[i].direction.x);
            ray.ray.dir_y = static_cast<float>(rays[i].direction.y);
            ray.ray.dir_z = static_cast<float>(rays[i].direction.z);
            ray.ray.tfar = INFINITY;
            ray.ray.mask = ~0U;
            ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &ray);
            distances[i] = ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? no_hit : ray.ray.tfar;
            if (!faces.empty()) faces[i] = ray.hit.primID;
        }
    }

    /// \param coherent  tells Embree that the rays are similar
    void by_eights(bool coherent, std::span<const SearchRay> rays, std::span<double> distances,
                   std::span<std::uint32_t> faces) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (std::size_t at = 0; at < rays.size(); at += 8) {
            const std::size_t count = std::min<std::size_t>(8, rays.size() - at);
            alignas(32) int valid[8];
            alignas(32) RTCRayHit8 eight{};
            for (std::size_t i = 0; i < 8; ++i) {
                const SearchRay& ray = rays[at + std::min(i, count - 1)];
                valid[i] = i < count ? -1 : 0;
                eight.ray.org_x[i] = static_cast<float>(ray.origin.x);
                eight.ray.org_y[i] = static_cast<float>(ray.origin.y);
                eight.ray.org_z[i] = static_cast<float>(ray.origin.z);
                eight.ray.dir_x[i] = static_cast<float>(ray.direction.x);
                eight.ray.dir_y[i] = static_cast<float>(ray.direction.y);
                eight.ray.dir_z[i] = static_cast<float>(ray.direction.z);
                eight.ray.tfar[i] = INFINITY;
                eight.ray.mask[i] = ~0U;
                eight.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            }
            rtcIntersect8(valid, scene_, &context, &eight);
            for (std::size_t i = 0; i < count; ++i) {
                distances[at + i] =
                    eight.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? no_hit : eight.ray.tfar[i];
                if (!faces.empty()) faces[at + i] = eight.hit.primID[i];
            }
        }
    }

  private:
    RTCDevice device_;
    RTCScene scene_;
};

}  // namespace

std::vector<NamedSearch> embree_searches(const Mesh& mesh) {
    const auto fast = std::make_shared<const Prepared>(mesh, false);
    const auto robust = std::make_shared<const Prepared>(mesh, true);
    return {
        {"Embree, float, one ray", [fast](auto... asked) { fast->one_by_one(asked...); }},
        {"Embree, float, one ray, robust",
         [robust](auto... asked) { robust->one_by_one(asked...); }},
        {"Embree, float, eight rays", [fast](auto... asked) { fast->by_eights(true, asked...); }},
        {"Embree, float, eight rays, robust",
         [robust](auto... asked) { robust->by_eights(true, asked...); }},
    };
}

#else

std::vector<NamedSearch> embree_searches(const Mesh&) {
    return {};
}

#endif

}  // namespace lancer::search
