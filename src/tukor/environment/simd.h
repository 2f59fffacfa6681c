// Several numbers in one register, where compilers need to be told.
#pragma once

namespace tukor {

using Float8 = float __attribute__((vector_size(32)));
using Double4 = double __attribute__((vector_size(32)));

}  // namespace tukor
