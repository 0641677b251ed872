// SPDX-License-Identifier: MIT
#include "machine/host/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fmt/format.h>

namespace rasterloom::host {

void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    auto partial = path;
    partial += ".partial";
    errno = 0;
    std::ofstream file(partial, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    file.close();
    std::error_code error;
    std::string reason;
    if (!file)
        reason = errno != 0 ? std::strerror(errno) : "the file system took no more";
    if (reason.empty()) {
        std::filesystem::rename(partial, path, error);
        if (!error)
            return;
        reason = error.message();
    }
    std::filesystem::remove(partial, error);
    throw std::runtime_error(fmt::format("{}: cannot be written: {}", path.string(), reason));
}

}  // namespace rasterloom::host
