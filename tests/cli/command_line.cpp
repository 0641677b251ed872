// SPDX-License-Identifier: MIT
#include "tests/cli/command_line.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <sys/wait.h>

namespace rasterloom::cli {

namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& word) {
    std::string text(1, '\'');
    for (const char c : word) {
        text += c;
        if (c == '\'') {
            text += "\\''";
        }
    }
    text += '\'';
    return text;
}

}  // namespace

std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void CommandLine::SetUp() {
    fs::create_directories(folder_ / "work");
}

Finished CommandLine::rasterloom(const std::vector<std::string>& arguments) const {
    std::string line = "cd ";
    line.append(quoted((folder_ / "work").string())).append(" && ");
    line.append(quoted(RASTERLOOM_BINARY_DIR "/rasterloom"));
    for (const std::string& argument : arguments) {
        line.append(" ").append(quoted(argument));
    }
    line.append(" >").append(quoted((folder_ / "stdout").string()));
    line.append(" 2>").append(quoted((folder_ / "stderr").string()));
    const int raw = std::system(line.c_str());
    return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, read_text(folder_ / "stdout"),
            read_text(folder_ / "stderr")};
}

std::vector<std::string> CommandLine::files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "work")) {
        names.push_back(entry.path().lexically_relative(folder_ / "work").string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace rasterloom::cli
