// Lists in messages: see format.h.
#pragma once
#include <fmt/format.h>
