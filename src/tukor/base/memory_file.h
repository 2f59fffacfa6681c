// Files where there is no file system: a host gives them by name, readers find them as MappedFile.
// Built for WebAssembly only.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace tukor {

/// Makes `bytes` the contents of the file `name`. They must not change while a MappedFile shows
/// them.
void giveMemoryFile(std::string name, std::vector<std::byte> bytes);

/// Takes all files away; no MappedFile may show one.
void forgetMemoryFiles();

}  // namespace tukor
