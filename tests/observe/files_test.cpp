// SPDX-License-Identifier: MIT
#include "machine/observe/message_csv.hpp"
#include "machine/observe/statistics_files.hpp"
#include "tests/observe/small_run.hpp"
#include "tests/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rasterloom::observe {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

TEST(StatisticsJson, CarriesUnitsAndSums) {
    const auto json = nlohmann::json::parse(statistics_json(small_run()));
    EXPECT_EQ(json["nodes"], 3);
    EXPECT_EQ(json["u_ps"], 5'000'000);
    EXPECT_EQ(json["instructions"], 30);
    EXPECT_EQ(json["messages"], 3);
    EXPECT_EQ(json["frames"][0]["duration_u"], 200);
    EXPECT_EQ(json["phases"].size(), 2U);
    EXPECT_EQ(json["phases"][0]["name"], "rotate");
    EXPECT_EQ(json["phases"][1]["name"], "phase 1");
    EXPECT_EQ(json["phases"][0]["all_nodes"]["busy_ps"], 600'000'000);
    EXPECT_EQ(json["phases"][0]["synchronous"]["rounds"], 2);
    EXPECT_DOUBLE_EQ(json["phases"][0]["synchronous"]["utilisation"][0], 2.0 / 3);
    EXPECT_EQ(json["activities"][0]["name"], "route");
}

TEST(NodesCsv, HasOneRowANodeAndQuotesNames) {
    const auto lines = lines_of(nodes_csv(small_run()));
    ASSERT_EQ(lines.size(), 4U);
    const auto commas = std::count(lines[0].begin(), lines[0].end(), ',');
    EXPECT_EQ(std::count(lines[1].begin(), lines[1].end(), ','), commas);
    EXPECT_TRUE(
        lines[2].starts_with("1,\"odd, \"\"name\"\"\",10,20,200000000,50000000,0,0,0,0,750000000,"))
        << lines[2];
}

TEST(LinksCsv, ShowsTheShareOfTimeALinkWasBusy) {
    const auto lines = lines_of(links_csv(small_run()));
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[1], "0,node,0,1,\"odd, \"\"name\"\"\",3,60,250000000,0.250000,7000000,2,1");
}

TEST(MessagesCsv, WritesARowAHop) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "messages.csv";
    MessageCsv csv(path);
    MessageRecord record;
    record.id = 42;
    record.destination = 3;
    record.kind = 2;
    record.consumed = at_us(1);
    constexpr int kMany = 5000;  // more than one buffer
    for (int i = 0; i < kMany; ++i) {
        csv.message_consumed(record);
    }
    csv.close();
    std::ifstream file(path);
    std::string header, row;
    std::getline(file, header);
    std::getline(file, row);
    EXPECT_EQ(
        header,
        "id,source,port,destination,kind,bytes,hops,queued_ps,started_ps,delivered_ps,consumed_ps");
    EXPECT_EQ(row, "42,0,0,3,2,0,0,0,0,0,1000000");
    int rows = 1;
    while (std::getline(file, row)) {
        ++rows;
    }
    EXPECT_EQ(rows, kMany);
}

TEST(MessagesCsv, SaysWhichFileItCannotWrite) {
    EXPECT_THROW(MessageCsv("/nonexistent/messages.csv"), std::runtime_error);
    if (std::filesystem::exists("/dev/full")) {
        MessageCsv csv("/dev/full");
        EXPECT_THROW(csv.close(), std::runtime_error);
    }
}

}  // namespace
}  // namespace rasterloom::observe
