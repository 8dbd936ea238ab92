// The code that is compiled once for each level, in the level's namespace; in the order of use.
#pragma once

#include "tracer/wide/job.h"
//
#include "tracer/wide/floats.h"
#include "tracer/wide/fours.h"
//
#include "tracer/wide/vectors.h"
//
#include "tracer/wide/absorption.h"
#include "tracer/wide/rays.h"
//
#include "tracer/wide/frames.h"
//
#include "tracer/wide/slabs.h"
//
#include "tracer/wide/search.h"
//
#include "tracer/wide/hits.h"
//
#include "tracer/wide/balls.h"
#include "tracer/wide/boxes.h"
#include "tracer/wide/discs.h"
#include "tracer/wide/frustums.h"
#include "tracer/wide/planes.h"
#include "tracer/wide/triangles.h"
//
#include "tracer/wide/frustum_crossings.h"
#include "tracer/wide/torus_lines.h"
//
#include "tracer/wide/tori.h"
//
#include "tracer/wide/piece_views.h"
//
#include "tracer/wide/plane_zeros.h"
//
#include "tracer/wide/patch_rays.h"
//
#include "tracer/wide/patch_heights.h"
//
#include "tracer/wide/patches.h"
//
#include "tracer/wide/lone_rays.h"
#include "tracer/wide/meshes.h"
//
#include "tracer/wide/lone_meshes.h"
#include "tracer/wide/mesh_edges.h"
//
#include "tracer/wide/nearest.h"
#include "tracer/wide/see_throughs.h"
//
#include "tracer/wide/see_through_shapes.h"
//
#include "tracer/wide/shadows.h"
//
#include "tracer/wide/surface.h"
//
#include "tracer/wide/mesh_surfaces.h"
//
#include "tracer/wide/frustum_surfaces.h"
#include "tracer/wide/patch_surfaces.h"
#include "tracer/wide/simple_surfaces.h"
#include "tracer/wide/textures.h"
#include "tracer/wide/torus_surfaces.h"
//
#include "tracer/wide/surfaces.h"
//
#include "tracer/wide/lighting.h"
#include "tracer/wide/optics.h"
//
#include "tracer/wide/chains.h"
#include "tracer/wide/wave.h"
//
#include "tracer/wide/glass_media.h"
//
#include "tracer/wide/glass.h"
//
#include "tracer/wide/glass_waves.h"
