// SPDX-License-Identifier: MIT
// In place of the page where the program is built without it.
#include "machine/observe/page/report_page.hpp"

namespace rasterloom::observe {

std::optional<std::string> page_template() {
    return std::nullopt;
}

}  // namespace rasterloom::observe
