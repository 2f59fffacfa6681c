// Shader programs: compiled, linked, with uniforms set by name.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "tukor/gl/handles.h"
#include "tukor/gl/shader_source.h"

namespace tukor::gl {

/// A linked program of the current context.
class Program {
public:
    /// `defines` are whole lines put after #version: "#define LEVEL 1\n". Throws Error with the
    /// driver's log in which file numbers are replaced by names: `tukor/optics/fresnel.h:17: ...`.
    Program(const ShaderSource& vertex, const ShaderSource& fragment,
            std::string_view defines = {});

    [[nodiscard]] GLuint id() const noexcept { return handle_.id(); }
    void use() const { glUseProgram(id()); }

    /// Sets a uniform and makes the program current. A name that no shader uses is ignored:
    /// compilers drop uniforms.
    void set(std::string_view name, int value) const;
    void set(std::string_view name, std::uint32_t value) const;
    void set(std::string_view name, float value) const;
    void set(std::string_view name, glm::vec2 value) const;
    void set(std::string_view name, glm::vec3 value) const;
    void set(std::string_view name, glm::vec4 value) const;
    void set(std::string_view name, glm::ivec2 value) const;
    /// An array; `name` ends with [0].
    void set(std::string_view name, std::span<const glm::vec4> values) const;
    void set(std::string_view name, const glm::mat3& value) const;
    void set(std::string_view name, const glm::mat4& value) const;

private:
    [[nodiscard]] GLint location(std::string_view name) const;

    Handle<ProgramKind> handle_;
    std::map<std::string, GLint, std::less<>> locations_;
};

/// A driver's log with `0:17(3): error` and `ERROR: 0:17: ` told as `tukor/gl/shaders/a.frag:17`.
[[nodiscard]] std::string namedLog(std::string_view log, const ShaderSource& source);

}  // namespace tukor::gl
