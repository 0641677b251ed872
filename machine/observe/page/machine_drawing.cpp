// SPDX-License-Identifier: MIT
#include "machine/observe/page/machine_drawing.hpp"

namespace rasterloom::observe {

std::string_view name_of(MachineDrawing::Layout layout) {
    switch (layout) {
        case MachineDrawing::Layout::sphere:
            return "sphere";
        case MachineDrawing::Layout::plane:
            return "plane";
        case MachineDrawing::Layout::screen:
            return "screen";
    }
    return "";
}

std::string_view name_of(MachineDrawing::Part::Place place) {
    switch (place) {
        case MachineDrawing::Part::Place::before:
            return "before";
        case MachineDrawing::Part::Place::beside:
            return "beside";
        case MachineDrawing::Part::Place::behind:
            return "behind";
    }
    return "";
}

}  // namespace rasterloom::observe
