// Runs a fuzz target over the files of a folder: what libFuzzer does with a corpus, without clang.
//
// Each file is also tried cut off and with single bits flipped, so that a corpus of valid files
// tests the error paths as well.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "tukor/base/error.h"
#include "tukor/base/file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void run(const std::vector<std::uint8_t>& bytes) {
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

void runVariants(const std::filesystem::path& path) {
    constexpr int kVariants = 40;  // keeps a corpus of a dozen files within a second
    const auto file = tukor::readFile(path);
    const auto* data = reinterpret_cast<const std::uint8_t*>(file.data());
    const std::vector<std::uint8_t> whole(data, data + file.size());
    run(whole);
    unsigned state = 1;
    for (int i = 0; i < kVariants && !whole.empty(); ++i) {
        state = state * 1664525u + 1013904223u;
        auto bytes = whole;
        bytes[(state >> 8) % bytes.size()] ^= static_cast<std::uint8_t>(1u << (i % 8));
        run(bytes);
        bytes = whole;
        bytes.resize(whole.size() * static_cast<std::size_t>(i) / kVariants);
        run(bytes);
    }
}

}  // namespace

int main(int count, char** arguments) {
    int files = 0;
    try {
        for (int i = 1; i < count; ++i)
            for (const auto& entry : std::filesystem::recursive_directory_iterator(arguments[i])) {
                if (!entry.is_regular_file()) continue;
                std::printf("%s\n", entry.path().c_str());
                std::fflush(stdout);  // the last line names the culprit of a crash
                runVariants(entry.path());
                ++files;
            }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "replay: %s\n", error.what());
        return 1;
    }
    if (files == 0) std::fprintf(stderr, "replay: no corpus\n");
    return files == 0 ? 1 : 0;
}
