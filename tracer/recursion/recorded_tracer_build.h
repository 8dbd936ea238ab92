// RecordedTracer's recursion, for the one file in which a number type is instantiated.
#pragma once

#include "tracer/recursion/ray_tree_recorder.h"
#include "tracer/recursion/recorded_tracer.h"
#include "tracer/recursion/whitted.h"

namespace lancer {

template <class Real>
Vec3<Real> RecordedTracer<Real>::camera_ray(const Ray<Real>& ray, Real at_camera,
                                            const Ray<Real>& from_camera,
                                            ProbeRecord<Real>* record) {
    using Recorder = RayTreeRecorder<Real>;
    const Recorder recorder(world_, limits_, tree_);
    if (is_all_opaque(world_))
        return OpaqueTracer<Real, Recorder>(world_, limits_, recorder)
            .camera_ray(ray, at_camera, from_camera, record);
    return Whitted<Real, Recorder>(world_, limits_, recorder)
        .camera_ray(ray, at_camera, from_camera, record);
}

}  // namespace lancer
