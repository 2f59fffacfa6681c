#include "tukor/scene/json_document.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "tukor/base/error.h"
#include "tukor/base/number_text.h"

namespace tukor {

namespace {

constexpr int kDeepest = 64;                    // extras and extensions nest; ten levels are many
constexpr std::size_t kMostValues = 2'000'000;  // at 28 bytes

void appendUtf8(std::string& text, std::uint32_t c) {
    if (c < 0x80) {
        text += static_cast<char>(c);
        return;
    }
    const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;  // bytes after the first
    constexpr int kFirst[] = {0, 0xc0, 0xe0, 0xf0};
    text += static_cast<char>(kFirst[more] | static_cast<int>(c >> 6 * more));
    for (int i = more - 1; i >= 0; --i) text += static_cast<char>(0x80 | (c >> 6 * i & 0x3f));
}

bool isDigit(char c) noexcept {
    return c >= '0' && c <= '9';
}

}  // namespace

std::optional<std::size_t> JsonDocument::find(std::size_t value, const char* name) const noexcept {
    std::size_t first = 0, last = size(value);
    while (first < last) {  // the first one behind
        const std::size_t middle = (first + last) / 2;
        if (std::strcmp(this->name(child(value, middle)), name) <= 0)
            first = middle + 1;
        else
            last = middle;
    }
    if (first == 0) return std::nullopt;
    const std::size_t found = child(value, first - 1);
    if (std::strcmp(this->name(found), name) != 0) return std::nullopt;
    return found;
}

class JsonParser {
public:
    JsonParser(std::string_view name, std::string_view text) : name_(name), text_(text) {}

    JsonDocument parse() {
        if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // a byte order mark
        json_.texts_ += '\0';                            // the name of what has none
        parseValue(0, 0);
        skipBlanks();
        if (at_ != text_.size()) refuse();
        return std::move(json_);
    }

private:
    [[noreturn]] void refuse() const {
        throw Error(
            fmt::format("{}: not JSON: wrong at byte {} of {}", name_, at_ + 1, text_.size()));
    }

    void skipBlanks() noexcept {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' ||
                                      text_[at_] == '\n' || text_[at_] == '\r'))
            ++at_;
    }

    [[nodiscard]] char next() const noexcept { return at_ < text_.size() ? text_[at_] : '\0'; }

    bool take(char c) noexcept {
        if (next() != c) return false;
        ++at_;
        return true;
    }

    void expect(std::string_view word) {
        for (const char c : word)
            if (!take(c)) refuse();
    }

    JsonDocument::Value& value(std::size_t index) noexcept { return json_.values_[index]; }

    void parseValue(std::size_t index, int depth) {
        skipBlanks();
        JsonKind kind = JsonKind::null;
        switch (next()) {
            case '{':
            case '[':
                parseChildren(index, depth + 1);
                return;
            case '"':
                kind = JsonKind::string;
                value(index).first = parseString();
                value(index).size =
                    static_cast<std::uint32_t>(json_.texts_.size() - 1 - value(index).first);
                break;
            case 't':
                expect("true");
                kind = JsonKind::boolean;
                value(index).size = 1;
                break;
            case 'f':
                expect("false");
                kind = JsonKind::boolean;
                break;
            case 'n':
                expect("null");
                break;
            default:
                kind = JsonKind::number;
                value(index).number = parseNumber();
        }
        value(index).kind = kind;
    }

    void parseChildren(std::size_t index, int depth) {
        if (depth > kDeepest)
            throw Error(fmt::format("{}: JSON nested deeper than {} levels", name_, kDeepest));
        const bool object = next() == '{';
        const char close = object ? '}' : ']';
        const std::size_t mark = pending_.size();
        ++at_;
        skipBlanks();
        if (!take(close)) {
            do {
                const std::size_t child = json_.values_.size();
                if (child >= kMostValues)
                    throw Error(fmt::format("{}: JSON of more than {} values", name_, kMostValues));
                json_.values_.emplace_back();
                pending_.push_back(static_cast<std::uint32_t>(child));
                skipBlanks();
                if (object) {
                    value(child).name = parseString();
                    skipBlanks();
                    expect(":");
                }
                parseValue(child, depth);
                skipBlanks();
            } while (take(','));
            expect({&close, 1});
        }
        if (object)  // by name, so that a member is found quickly; of equal names the last counts
            std::sort(pending_.begin() + static_cast<std::ptrdiff_t>(mark), pending_.end(),
                      [&](std::uint32_t a, std::uint32_t b) {
                          const int order = std::strcmp(json_.name(a), json_.name(b));
                          return order != 0 ? order < 0 : a < b;
                      });
        JsonDocument::Value& parent = value(index);
        parent.kind = object ? JsonKind::object : JsonKind::array;
        parent.first = static_cast<std::uint32_t>(json_.children_.size());
        parent.size = static_cast<std::uint32_t>(pending_.size() - mark);
        json_.children_.insert(json_.children_.end(),
                               pending_.begin() + static_cast<std::ptrdiff_t>(mark),
                               pending_.end());
        pending_.resize(mark);
    }

    // Where its text begins; it ends before the last byte of all texts.
    std::uint32_t parseString() {
        expect("\"");
        const std::size_t first = json_.texts_.size();
        for (;;) {
            const char c = next();
            if (static_cast<unsigned char>(c) < 0x20) refuse();  // the end, or a control character
            if (c == '\\') {
                ++at_;
                parseEscape();
            } else if (static_cast<unsigned char>(c) >= 0x80) {
                parseUtf8();
            } else {
                ++at_;
                if (c == '"') break;
                json_.texts_ += c;
            }
        }
        json_.texts_ += '\0';
        return static_cast<std::uint32_t>(first);
    }

    void parseEscape() {
        constexpr std::string_view kLetters = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
        const char c = next();
        if (c == 'u') {
            ++at_;
            std::uint32_t code = parseHex4();
            if (code >= 0xdc00 && code < 0xe000) refuse();
            if (code >= 0xd800 && code < 0xdc00) {  // the first half of a pair
                expect("\\u");
                const std::uint32_t low = parseHex4();
                if (low < 0xdc00 || low >= 0xe000) refuse();
                code = 0x10000 + ((code - 0xd800) << 10 | (low - 0xdc00));
            }
            appendUtf8(json_.texts_, code);
            return;
        }
        const std::size_t place = kLetters.find(c);
        if (place == kLetters.npos) refuse();
        json_.texts_ += kMeanings[place];
        ++at_;
    }

    std::uint32_t parseHex4() {
        std::uint32_t code = 0;
        for (int i = 0; i < 4; ++i, ++at_) {
            const char c = next();
            const char lower = static_cast<char>(c | 0x20);
            if (isDigit(c))
                code = code << 4 | static_cast<std::uint32_t>(c - '0');
            else if (lower >= 'a' && lower <= 'f')
                code = code << 4 | static_cast<std::uint32_t>(lower - 'a' + 10);
            else
                refuse();
        }
        return code;
    }

    // One character of several bytes; overlong ones and halves of pairs are not UTF-8.
    void parseUtf8() {
        const auto first = static_cast<unsigned char>(next());
        const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
        if (first < 0xc2 || first > 0xf4) refuse();
        std::uint32_t code = first & (0x3fu >> more);
        const std::size_t start = at_++;
        for (int i = 0; i < more; ++i, ++at_) {
            const auto byte = static_cast<unsigned char>(next());
            if ((byte & 0xc0) != 0x80) refuse();
            code = code << 6 | (byte & 0x3fu);
        }
        const bool overlong = (more == 2 && code < 0x800) || (more == 3 && code < 0x10000);
        if (overlong || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) refuse();
        json_.texts_ += text_.substr(start, at_ - start);
    }

    void digits() {
        if (!isDigit(next())) refuse();
        while (isDigit(next())) ++at_;
    }

    double parseNumber() {
        const std::size_t start = at_;
        take('-');
        if (!take('0')) digits();
        if (take('.')) digits();
        if (next() == 'e' || next() == 'E') {
            ++at_;
            if (!take('+')) take('-');
            digits();
        }
        const std::optional<double> number = numberFromText(text_.substr(start, at_ - start));
        if (!number || !std::isfinite(*number))
            throw Error(fmt::format("{}: not JSON: a number is beyond all bounds", name_));
        return *number;
    }

    std::string_view name_;
    std::string_view text_;
    std::size_t at_ = 0;
    JsonDocument json_;
    std::vector<std::uint32_t> pending_;  // children of what is still open
};

JsonDocument parseJson(std::string_view name, std::span<const std::byte> bytes) {
    return JsonParser(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}).parse();
}

}  // namespace tukor
