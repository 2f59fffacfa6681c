#include "tukor/gl/program.h"

#include <cctype>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include "tukor/base/error.h"

namespace tukor::gl {

namespace {

struct OwnedShader {
    explicit OwnedShader(GLenum type) : id(glCreateShader(type)) {}
    OwnedShader(const OwnedShader&) = delete;
    OwnedShader& operator=(const OwnedShader&) = delete;
    ~OwnedShader() { glDeleteShader(id); }
    GLuint id;
};

void compile(const OwnedShader& shader, const ShaderSource& source, std::string_view defines) {
    const std::string_view text = source.text;
    const std::size_t firstLine = text.find('\n') + 1;  // #version must stay first
    const std::string_view parts[] = {text.substr(0, firstLine), defines, text.substr(firstLine)};
    const char* strings[3];
    GLint lengths[3];
    for (int i = 0; i < 3; ++i) {
        strings[i] = parts[i].data() == nullptr ? "" : parts[i].data();
        lengths[i] = static_cast<GLint>(parts[i].size());
    }
    glShaderSource(shader.id, 3, strings, lengths);
    glCompileShader(shader.id);
}

void throwIfBroken(const OwnedShader& shader, const ShaderSource& source) {
    GLint ok = GL_FALSE;
    glGetShaderiv(shader.id, GL_COMPILE_STATUS, &ok);
    if (ok == GL_TRUE) return;
    GLint size = 0;
    glGetShaderiv(shader.id, GL_INFO_LOG_LENGTH, &size);
    std::vector<char> log(static_cast<std::size_t>(size) + 1, '\0');
    glGetShaderInfoLog(shader.id, size, nullptr, log.data());
    throw Error(fmt::format("{}: the driver cannot compile it:\n{}", source.files.front(),
                            namedLog(log.data(), source)));
}

}  // namespace

std::string namedLog(std::string_view log, const ShaderSource& source) {
    std::string named;
    bool lineStart = true;
    for (std::size_t i = 0; i < log.size();) {
        const auto isDigit = [&](std::size_t at) {
            return at < log.size() && std::isdigit(static_cast<unsigned char>(log[at])) != 0;
        };
        const bool wordStart = i == 0 || lineStart || log[i - 1] == ' ';
        std::size_t fileEnd = i;
        while (isDigit(fileEnd)) ++fileEnd;
        std::size_t lineEnd = fileEnd + 1;
        while (isDigit(lineEnd)) ++lineEnd;
        const bool place = wordStart && fileEnd > i && fileEnd - i < 4 && fileEnd < log.size() &&
                           log[fileEnd] == ':' && lineEnd > fileEnd + 1;
        const std::size_t number =
            place ? static_cast<std::size_t>(std::atoi(std::string(log.substr(i, 4)).c_str()))
                  : source.files.size();
        if (number < source.files.size()) {
            named += source.files[number];
            named += log.substr(fileEnd, lineEnd - fileEnd);
            i = lineEnd;
            lineStart = false;
            continue;
        }
        lineStart = log[i] == '\n';
        named += log[i++];
    }
    while (!named.empty() && std::isspace(static_cast<unsigned char>(named.back())) != 0)
        named.pop_back();
    return named;
}

Program::Program(const ShaderSource& vertex, const ShaderSource& fragment,
                 std::string_view defines) {
    const OwnedShader vertexShader(GL_VERTEX_SHADER);
    const OwnedShader fragmentShader(GL_FRAGMENT_SHADER);
    compile(vertexShader, vertex, defines);
    compile(fragmentShader, fragment, defines);
    handle_ = Handle<ProgramKind>::make();
    glAttachShader(id(), vertexShader.id);
    glAttachShader(id(), fragmentShader.id);
    glLinkProgram(id());
    GLint ok = GL_FALSE;
    glGetProgramiv(id(), GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE) {
        throwIfBroken(vertexShader, vertex);
        throwIfBroken(fragmentShader, fragment);
        GLint size = 0;
        glGetProgramiv(id(), GL_INFO_LOG_LENGTH, &size);
        std::vector<char> log(static_cast<std::size_t>(size) + 1, '\0');
        glGetProgramInfoLog(id(), size, nullptr, log.data());
        throw Error(fmt::format("{} with {}: the driver cannot link them:\n{}",
                                vertex.files.front(), fragment.files.front(), log.data()));
    }

    GLint count = 0;
    glGetProgramiv(id(), GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char name[128];  // longer than any name in gl/shaders
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(id(), static_cast<GLuint>(i), sizeof(name), nullptr, &size, &type, name);
        locations_[name] = glGetUniformLocation(id(), name);
    }
}

GLint Program::location(std::string_view name) const {
    use();
    const auto found = locations_.find(name);
    return found == locations_.end() ? -1 : found->second;  // GL ignores writes to -1
}

void Program::set(std::string_view name, int value) const {
    glUniform1i(location(name), value);
}
void Program::set(std::string_view name, float value) const {
    glUniform1f(location(name), value);
}
void Program::set(std::string_view name, glm::vec2 value) const {
    glUniform2fv(location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, glm::vec3 value) const {
    glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, glm::vec4 value) const {
    glUniform4fv(location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, glm::ivec2 value) const {
    glUniform2iv(location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, std::uint32_t value) const {
    glUniform1ui(location(name), value);
}
void Program::set(std::string_view name, std::span<const glm::vec4> values) const {
    if (values.empty()) return;
    glUniform4fv(location(name), static_cast<GLsizei>(values.size()), &values.front().x);
}
void Program::set(std::string_view name, const glm::mat3& value) const {
    glUniformMatrix3fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat4& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace tukor::gl
