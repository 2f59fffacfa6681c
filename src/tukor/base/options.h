// The vocabulary of option tables: one `describe(options, field)` per option struct, read by every
// front end.
//
// A front end is a visitor: field(name, value, extra, help) with a Range for numbers or Spellings
// for enumerations.
#pragma once
#include <span>
#include <string_view>
#include <utility>

namespace tukor {

/// Inclusive bounds of a number, in the unit the flag is given in.
template <class T>
struct Range {
    T least;
    T most;
};

/// The words for the values of an enumeration, in the order shown to people.
template <class Enum>
using Spellings = std::span<const std::pair<Enum, std::string_view>>;

}  // namespace tukor
