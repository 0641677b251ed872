// SPDX-License-Identifier: MIT
#include "isa/registry.hpp"

#include "isa/listing.hpp"
#include "isa/pdp11/pdp11.hpp"

#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

#include <gmock/gmock.h>

namespace rasterloom::isa {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kBinaries = RASTERLOOM_BINARY_DIR;

std::string complaint(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

TEST(IsaRegistry, FindsWhatWasAddedAndNamesWhatItKnows) {
    IsaRegistry registry;
    registry.add(pdp11::pdp11_isa());
    EXPECT_EQ(&registry.find("pdp11"), &pdp11::pdp11_isa());
    EXPECT_EQ(complaint([&] { registry.find("pdp10"); }),
              "there is no instruction set 'pdp10'; known: pdp11; did you mean 'pdp11'?");
    EXPECT_THAT(complaint([&] { registry.add(pdp11::pdp11_isa()); }), HasSubstr("'pdp11' already"));
}

TEST(IsaRegistry, LoadsAPlugInOnce) {
    IsaRegistry registry;
    const Isa& toy = registry.load(kBinaries / "librasterloom_toy.so");
    EXPECT_EQ(toy.name(), "toy");
    EXPECT_EQ(&registry.load(kBinaries / "librasterloom_toy.so"), &toy);
    EXPECT_EQ(registry.all().size(), 1U);
    EXPECT_EQ(&registry.find("toy"), &toy);
}

TEST(IsaRegistry, SaysWhichFileIsNoPlugInAndWhy) {
    IsaRegistry registry;
    EXPECT_THAT(complaint([&] { registry.load("no/such.so"); }),
                HasSubstr("no/such.so: there is no such file"));
    const std::filesystem::path text = kBinaries / "registry_test.so";
    std::ofstream(text) << "not a shared object";
    EXPECT_THAT(complaint([&] { registry.load(text); }),
                HasSubstr("registry_test.so: cannot be loaded"));
    std::filesystem::remove(text);
    EXPECT_THAT(complaint([&] { registry.load(kBinaries / "libisa_not_a_plugin.so"); }),
                HasSubstr("libisa_not_a_plugin.so: is no instruction set: it does not export "
                          "rasterloom_isa_plugin"));
    EXPECT_THAT(
        complaint([&] { registry.load(kBinaries / "libisa_old_plugin.so"); }),
        HasSubstr("was built for version 0 of the plug-in contract, version 3 is expected"));
    EXPECT_TRUE(registry.all().empty());
}

TEST(Listing, ShowsAddressWordsSourceAndCycles) {
    const Isa& isa = pdp11::pdp11_isa();
    const Assembly assembly =
        assemble_text(isa, "t.s", ". = 1000\nx: mov #5, @#x ; store\n.byte 1\n.blkb 40\n");
    ASSERT_TRUE(assembly.ok());
    const std::string listing = make_listing(assembly, isa, {"parks", {}});
    EXPECT_THAT(listing,
                HasSubstr("001000  012737 000005 001000       3    1  x: mov #5, @#x ; store\n"));
    EXPECT_THAT(listing, HasSubstr("001006  001                                .byte 1\n"));
    EXPECT_THAT(listing, HasSubstr("... 32 bytes"));
    EXPECT_THAT(listing, HasSubstr("001000  x\n"));
    EXPECT_THROW(make_listing(assembly, isa, {"nonesuch", {}}), std::invalid_argument);
}

TEST(Listing, ShowsOtherRadicesAndWordsOfBytes) {
    IsaRegistry registry;
    const Isa& isa = registry.load(kBinaries / "librasterloom_toy.so");
    const Assembly assembly = assemble_text(isa, "t.s", " lda #255\n sta 0x1234\n");
    ASSERT_TRUE(assembly.ok());
    const std::string listing = make_listing(assembly, isa);
    EXPECT_THAT(listing, HasSubstr("0000    13 ff                      2    0   lda #255\n"));
    EXPECT_THAT(listing, HasSubstr("0002    14 34 12                   3    1   sta 0x1234\n"));
}

}  // namespace
}  // namespace rasterloom::isa
