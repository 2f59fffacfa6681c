// What format.h has.
#pragma once
#include <fmt/format.h>
