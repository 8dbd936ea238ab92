// CutTracer's recursion, for the one file in which a number type is instantiated.
#pragma once

#include <optional>

#include "tracer/recursion/cut_recorder.h"
#include "tracer/recursion/cut_tracer.h"
#include "tracer/recursion/whitted.h"

namespace lancer {

template <class Real>
struct CutTracer<Real>::Tracers {
    Vec3<Real> share{};
    std::optional<OpaqueTracer<Real, CutRecorder<Real>>> opaque;
    std::optional<Whitted<Real, CutRecorder<Real>>> transparent;
};

template <class Real>
CutTracer<Real>::CutTracer(const World<Real>& world, const TraceLimits& limits)
    : tracers_(std::make_unique<Tracers>()) {
    const CutRecorder<Real> recorder(tracers_->share);
    if (is_all_opaque(world))
        tracers_->opaque.emplace(world, limits, recorder);
    else
        tracers_->transparent.emplace(world, limits, recorder);
}
template <class Real>
CutTracer<Real>::~CutTracer() = default;

template <class Real>
Vec3<Real> CutTracer<Real>::camera_ray(const Ray<Real>& ray, Real at_camera,
                                       const Ray<Real>& from_camera, ProbeRecord<Real>* record) {
    tracers_->share = {};
    if (tracers_->opaque)
        tracers_->opaque->camera_ray(ray, at_camera, from_camera, record);
    else
        tracers_->transparent->camera_ray(ray, at_camera, from_camera, record);
    return tracers_->share;
}

}  // namespace lancer
