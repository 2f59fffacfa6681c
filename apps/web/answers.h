// What both modules' exported functions share: errors as results below zero, and texts as JSON.
#pragma once
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>

namespace tukor::web {

inline std::string lastError;
inline std::string lastText;  // valid until the next call

template <class Body>
int guarded(const Body& body) {
    try {
        return body();
    } catch (const std::bad_alloc&) {
        lastError = "out of memory";
    } catch (const std::exception& error) {
        lastError = error.what();
    }
    return -1;
}

inline const char* kept(std::string text) {
    lastText = std::move(text);
    return lastText.c_str();
}

inline std::string jsonString(std::string_view text) {
    std::string json = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') json += '\\';
        json += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return json + '"';
}

inline std::string jsonArray(std::span<const std::string> texts) {
    std::string json = "[";
    for (const std::string& text : texts) json += (json.size() > 1 ? "," : "") + jsonString(text);
    return json + "]";
}

}  // namespace tukor::web
