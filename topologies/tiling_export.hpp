// SPDX-License-Identifier: MIT
// How a screen is dealt out, as tables and as a drawing, for `rasterloom describe --csv` and
// `--svg`.
#pragma once

#include "topologies/tiling.hpp"

#include <ostream>

namespace rasterloom::topology {

// node,name,x_start,y_start,x_step,y_step,columns,rows: one row a processor.
void write_grids_csv(std::ostream& out, const Distribution& distribution);

// element,name,kind,axis,line,low,high,first_processor,processors: one row a splitter, bus or leaf.
void write_elements_csv(std::ostream& out, const Distribution& distribution);

// The screen, y upwards, every pixel in its processor's colour, with the splitters' cuts (the
// thicker, the nearer to the host); beside it the pixels of one part's lower left corner, enlarged.
void write_tiling_svg(std::ostream& out, const Tiling& tiling, const Distribution& distribution);

}  // namespace rasterloom::topology
