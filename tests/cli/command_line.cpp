// SPDX-License-Identifier: MIT
#include "tests/cli/command_line.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

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
    fs::create_directories(work_);
}

Finished CommandLine::rasterloom(const std::vector<std::string>& arguments) const {
    std::string line = "cd ";
    line.append(quoted(work_.string())).append(" && ");
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

pid_t CommandLine::start(std::vector<std::string> arguments, rlim_t room) const {
    arguments.insert(arguments.begin(), "rasterloom");
    std::vector<char*> words;
    for (std::string& argument : arguments) {
        words.push_back(argument.data());
    }
    words.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit limit{room, room};
        std::signal(SIGXFSZ, SIG_IGN);  // a write fails instead
        if (::chdir(work_.c_str()) == 0 && ::setrlimit(RLIMIT_FSIZE, &limit) == 0) {
            ::execv(RASTERLOOM_BINARY_DIR "/rasterloom", words.data());
        }
        ::_exit(99);
    }
    return child;
}

int CommandLine::status_of(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

nlohmann::json CommandLine::json_of(const std::vector<std::string>& arguments) const {
    const Finished done = rasterloom(arguments);
    EXPECT_EQ(done.status, 0) << done.err;
    return nlohmann::json::parse(done.out);
}

void CommandLine::expect_refused(const std::vector<std::string>& arguments,
                                 const std::string& what) const {
    const Finished done = rasterloom(arguments);
    EXPECT_EQ(done.status, 2) << what;
    EXPECT_THAT(done.out, testing::IsEmpty());
    EXPECT_THAT(done.err, testing::HasSubstr(what));
}

void CommandLine::write(const std::string& name, const std::string& text) const {
    std::ofstream(work_ / name) << text;
}

std::vector<std::string> CommandLine::files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(work_)) {
        names.push_back(entry.path().lexically_relative(work_).string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace rasterloom::cli
