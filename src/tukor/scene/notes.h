// What a model asks for and is not rendered so: collected part by part, said once by name.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tukor {

/// Gathers remarks about one file. `about` names what is concerned, such as a material; empty when
/// the remark is about the whole file.
class Notes {
public:
    void add(std::string_view remark, std::string_view about = "");

    /// `remark: first, second, third and 4 more`, in the order of their first occurrence.
    [[nodiscard]] std::vector<std::string> sentences() const;

private:
    struct Remark {
        std::string text;
        std::vector<std::string> about;  // the first few
        int more = 0;
    };
    std::vector<Remark> remarks_;
};

}  // namespace tukor
