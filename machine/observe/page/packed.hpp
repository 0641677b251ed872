// SPDX-License-Identifier: MIT
// Bytes as text for a page: compressed as zlib does (RFC 1950), then in base64.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace rasterloom::observe {

std::string base64(std::span<const std::uint8_t> bytes);

// Throws std::bad_alloc only.
std::string packed(std::string_view bytes);

}  // namespace rasterloom::observe
