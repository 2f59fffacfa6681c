// The `tukor` command.
#include <cstdio>
#include <exception>

int main() {
    try {
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tukor: %s\n", error.what());
        return 1;
    }
}
