#include "tukor/scene/notes.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tukor/scene/sibling_file.h"

namespace tukor {

namespace {
constexpr std::size_t kNamed = 4;      // names told per remark
constexpr std::size_t kRemarks = 100;  // a hostile file could ask for endless different things
}  // namespace

void Notes::add(std::string_view remark, std::string_view about) {
    auto found = std::find_if(remarks_.begin(), remarks_.end(),
                              [&](const Remark& known) { return known.text == remark; });
    if (found == remarks_.end()) {
        if (remarks_.size() == kRemarks) return;
        found = remarks_.insert(remarks_.end(), Remark{std::string(remark), {}, 0});
    }
    if (about.empty()) return;
    const std::string name = printable(about);
    if (std::find(found->about.begin(), found->about.end(), name) != found->about.end()) return;
    if (found->about.size() < kNamed)
        found->about.push_back(name);
    else
        ++found->more;
}

std::vector<std::string> Notes::sentences() const {
    std::vector<std::string> sentences;
    for (const Remark& remark : remarks_) {
        std::string sentence = remark.text;
        if (!remark.about.empty()) sentence += fmt::format(": {}", fmt::join(remark.about, ", "));
        if (remark.more > 0) sentence += fmt::format(" and {} more", remark.more);
        sentences.push_back(std::move(sentence));
    }
    return sentences;
}

}  // namespace tukor
