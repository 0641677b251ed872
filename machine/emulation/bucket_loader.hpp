#pragma once
#include "isa/core.hpp"
#include "isa/image.hpp"
#include "machine/host/tile_renderer.hpp"
namespace rasterloom { inline void load_bucket(isa::Core&, const isa::Image&, int, const host::TileTexture*) {} }
