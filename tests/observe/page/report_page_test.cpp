// SPDX-License-Identifier: MIT
// What goes into report.html, unpacked again by means that are not the report's.
#include "machine/observe/page/report_page.hpp"

#include "machine/host/png.hpp"
#include "machine/observe/page/packed.hpp"
#include "machine/observe/statistics_files.hpp"
#include "tests/observe/small_run.hpp"

#include <cstring>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>
#include <zlib.h>

namespace rasterloom::observe {
namespace {

using Json = nlohmann::json;

std::string from_base64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        if (c == '=') {
            break;
        }
        bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
        held += 6;
        if (held >= 8) {
            held -= 8;
            bytes += static_cast<char>(bits >> held & 255U);
        }
    }
    return bytes;
}

std::string unpacked(const Json& text) {
    const std::string bytes = from_base64(text.get<std::string>());
    std::string result(1 << 20, '\0');
    uLongf size = result.size();
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(result.data()), &size,
                         reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
              Z_OK);
    result.resize(size);
    return result;
}

int bin_of(const std::string& bins, std::size_t at) {
    return static_cast<unsigned char>(bins[2 * at]) +
           256 * static_cast<unsigned char>(bins[2 * at + 1]);
}

// Three nodes, two links, a run of 1 ms in bins of 5 us.
RunTimeline small_timeline() {
    RunTimeline timeline({.nodes = 3,
                          .first_link = {0, 1, 2},
                          .links = 2,
                          .link_latency = Duration::microseconds(1),
                          .parts = {},
                          .cycle = Duration::microseconds(5)});
    timeline.interval_ended({0, NodeState::busy, 0, at_us(0), at_us(400)});
    timeline.interval_ended({0, NodeState::waiting_input, 0, at_us(400), at_us(1000)});
    timeline.message_consumed({.id = 0,
                               .destination = 1,
                               .bytes = 20,
                               .delivery = kNoCause,
                               .port = 0,
                               .kind = 0,
                               .hops = 1,
                               .queued = at_us(10),
                               .started = at_us(20),
                               .delivered = at_us(31),
                               .consumed = at_us(50)});
    return timeline;
}

struct Page {
    RunReport report = small_run();
    RunTimeline timeline = small_timeline();
    MachineDrawing drawing;
    std::vector<host::Picture> pictures{host::Picture(4, 2, 1, 7)};

    PageContent content() const { return {report, timeline, drawing, pictures}; }
    Json json() const { return Json::parse(page_json(content())); }
    Json series(const char* of, const char* name) const {
        const Json all = json();
        for (const Json& each : all["timeline"]["series"]) {
            if (each["of"] == of && each["name"] == name) {
                return each;
            }
        }
        ADD_FAILURE() << "no series " << name << " of " << of;
        return {};
    }
};

RC_GTEST_PROP(ReportPage, PacksBytesSoThatTheyComeBack, (const std::string& text)) {
    RC_ASSERT(unpacked(Json(packed(text))) == text);
}

TEST(ReportPage, HoldsTheOtherFilesAsTheyAre) {
    const Page page;
    const Json json = page.json();
    EXPECT_EQ(json["statistics"], Json::parse(statistics_json(page.report)));
    EXPECT_EQ(unpacked(json["tables"]["nodes"]), nodes_csv(page.report));
    EXPECT_EQ(unpacked(json["tables"]["links"]), links_csv(page.report));
    EXPECT_FALSE(json["tables"].contains("parts"));
}

TEST(ReportPage, HoldsEveryPictureAsItsFile) {
    const Page page;
    const std::string picture = page.json()["pictures"].at(0);
    const std::string start = "data:image/png;base64,";
    ASSERT_TRUE(picture.starts_with(start));
    const std::vector<std::uint8_t> expected = host::encode_png(page.pictures[0]);
    EXPECT_EQ(from_base64(picture.substr(start.size())),
              std::string(expected.begin(), expected.end()));
}

TEST(ReportPage, QuantisesBinsAndKeepsTotals) {
    const Page page;
    EXPECT_EQ(page.json()["timeline"]["bins"], 200);
    const Json busy = page.series("node", "busy");
    const std::string bins = unpacked(busy["bins"]);
    ASSERT_EQ(bins.size(), 2U * 3 * 200);
    EXPECT_EQ(bin_of(bins, 0), 65535);
    EXPECT_EQ(bin_of(bins, 79), 65535);
    EXPECT_EQ(bin_of(bins, 80), 0);
    double total = 0;
    const std::string totals = unpacked(busy["totals_ps"]);
    ASSERT_EQ(totals.size(), 3U * 8);
    std::memcpy(&total, totals.data(), 8);
    EXPECT_EQ(total, 4e8);
}

TEST(ReportPage, TakesQueuesAndLinksFromMessages) {
    const Page page;
    // Queued from 10 us, on the link from 20 to 30 us, at the receiver from 31 to 50 us.
    const std::string link = unpacked(page.series("link", "busy")["bins"]);
    const std::string waiting = unpacked(page.series("link", "waiting")["bins"]);
    const std::string input = unpacked(page.series("node", "input_queue")["bins"]);
    for (int bin = 0; bin < 12; ++bin) {
        const auto at = static_cast<std::size_t>(bin);
        EXPECT_EQ(bin_of(link, at), bin >= 4 && bin < 6 ? 65535 : 0) << bin;
        EXPECT_EQ(bin_of(waiting, at), bin >= 2 && bin < 4 ? 65535 : 0) << bin;
        EXPECT_EQ(bin_of(input, 200 + at), bin == 6              ? 52428
                                           : bin > 6 && bin < 10 ? 65535
                                                                 : 0)
            << bin;
    }
    EXPECT_EQ(page.json()["histograms"]["hops"], Json::parse("[[2,1]]"));
    EXPECT_EQ(page.json()["histograms"]["latency_ps"].at(0).at(1), 1);
}

TEST(ReportPage, BeginsNoTagInsideItsScript) {
    Page page;
    page.report.machine = "</script><!-- <b>";
    page.report.nodes[0].name = "<script>";
    if (!page_template()) {
        GTEST_SKIP() << "built without the report";
    }
    const std::string html = report_page(page.content());
    const std::string start = R"(<script type="application/json" id="run">)";
    const std::size_t at = html.find(start) + start.size();
    const std::string json = html.substr(at, html.find("</script>", at) - at);
    EXPECT_EQ(json.find('<'), std::string::npos);
    EXPECT_EQ(Json::parse(json)["statistics"]["machine"], page.report.machine);
}

TEST(ReportPage, RefersToNoOtherFile) {
    const auto page = page_template();
    if (!page) {
        GTEST_SKIP() << "built without the report";
    }
    EXPECT_EQ(page->find("<script src"), std::string::npos);
    EXPECT_EQ(page->find("rel=\"stylesheet\""), std::string::npos);
    EXPECT_EQ(page->find("@import"), std::string::npos);
    EXPECT_LT(page->size(), 1'000'000U);
}

TEST(LatencyClass, IsAtMostAnEighthBelow) {
    std::int64_t last = 0;
    for (std::int64_t ps = 0; ps < 100'000; ++ps) {
        const std::int64_t least = latency_class(Duration::picoseconds(ps));
        EXPECT_LE(least, ps);
        EXPECT_GE(least * 9, ps * 8 - 7);
        EXPECT_GE(least, last);
        EXPECT_EQ(latency_class(Duration::picoseconds(least)), least);
        last = least;
    }
}

}  // namespace
}  // namespace rasterloom::observe
