// SPDX-License-Identifier: MIT
// The reference for what the machines of tiles draw: the same scene in double precision, without
// the planes and the spans of tile_renderer.hpp. A pixel is covered when its sample is on the inner
// side of all three edges or on them. There depth, shade and the place in the texture follow from
// the sample's distances from the edges: affine in screen space, no perspective. The nearest
// triangle shows, the first of equally near ones; its level is the shade, or the shade times the
// nearest texel / 255, to the nearest level.
#pragma once

#include "machine/host/picture.hpp"
#include "machine/host/screen_triangle.hpp"
#include "machine/host/tile_renderer.hpp"

#include <span>

namespace rasterloom::host {

// One channel. Triangles that are no fronts are not drawn. `texture`: null for none.
Picture reference_triangles(std::span<const ScreenTriangle> triangles, int width, int height,
                            int background, const TileTexture* texture);

}  // namespace rasterloom::host
