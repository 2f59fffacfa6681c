// OpenGL ES 3 for the library, over a WebGL 2 context: the functions that it imports.

/** Those whose arguments are plain numbers, which WebGL takes as they are. */
const PLAIN = "activeTexture blendFunc blitFramebuffer checkFramebufferStatus clear clearColor colorMask cullFace depthFunc depthMask disable drawArrays drawElements " +
  "enable enableVertexAttribArray flush generateMipmap getError pixelStorei readBuffer renderbufferStorageMultisample scissor texParameteri " +
  "texStorage2D texStorage3D vertexAttribPointer viewport";
/** Arrays of uniforms: the function and its figures a value, of memory's floats or ints. */
const UNIFORMS = { uniform2fv: 2, uniform3fv: 3, uniform4fv: 4, uniformMatrix3fv: 9, uniformMatrix4fv: 16, uniform2iv: 2 };

const glName = (name) => "gl" + name[0].toUpperCase() + name.slice(1);

export function webglImports(gl, memory) {
  const objects = [null]; // by the numbers that OpenGL calls names
  const locations = [];
  const named = (object) => objects.push(object) - 1;
  const location = (id) => (id < 0 ? null : locations[id]);
  const list = (count, at) => memory.words.subarray(at >> 2, (at >> 2) + count);
  const imports = {};
  for (const name of PLAIN.split(" ")) imports[glName(name)] = gl[name].bind(gl);
  imports.glDepthRangef = (near, far) => gl.depthRange(near, far);

  for (const kind of ["Buffer", "Texture", "Renderbuffer", "Framebuffer", "VertexArray"]) {
    imports[`glGen${kind}s`] = (count, at) => list(count, at).forEach((_, i, ids) => (ids[i] = named(gl[`create${kind}`]())));
    imports[`glDelete${kind}s`] = (count, at) => {
      for (const id of list(count, at)) {
        gl[`delete${kind}`](objects[id]);
        delete objects[id];
      }
    };
    imports[`glBind${kind}`] = kind === "VertexArray" ? (id) => gl.bindVertexArray(objects[id]) : (target, id) => gl[`bind${kind}`](target, objects[id]);
  }
  for (const kind of ["Shader", "Program"]) {
    imports[`glCreate${kind}`] = (type) => named(gl[`create${kind}`](type));
    imports[`glDelete${kind}`] = (id) => {
      gl[`delete${kind}`](objects[id]);
      delete objects[id];
    };
    const log = (id) => gl[`get${kind}InfoLog`](objects[id]) ?? "";
    imports[`glGet${kind}iv`] = (id, what, at) => {
      memory.ints[at >> 2] = what === 0x8b84 ? new TextEncoder().encode(log(id)).length + 1 : Number(gl[`get${kind}Parameter`](objects[id], what)); // INFO_LOG_LENGTH
    };
    imports[`glGet${kind}InfoLog`] = (id, size, _, at) => size > 0 && memory.put(at, log(id).slice(0, size - 1));
  }
  for (const [name, figures] of Object.entries(UNIFORMS)) {
    const set = (id, count, at) => {
      const data = name.endsWith("iv") ? memory.ints : memory.floats;
      if (figures > 4) gl[name](location(id), false, data, at >> 2, count * figures);
      else gl[name](location(id), data, at >> 2, count * figures);
    };
    imports[glName(name)] = figures > 4 ? (id, count, _, at) => set(id, count, at) : set;
  }
  const pixels = (type, at) => { // of the kinds that the library hands over, and where they begin
    const kinds = { [gl.FLOAT]: memory.floats, [gl.HALF_FLOAT]: memory.shorts, [gl.UNSIGNED_INT]: memory.words };
    const data = kinds[type] ?? memory.bytes;
    return [data, at / data.BYTES_PER_ELEMENT];
  };
  return Object.assign(imports, {
    glUniform1i: (id, value) => gl.uniform1i(location(id), value),
    glUniform1ui: (id, value) => gl.uniform1ui(location(id), value),
    glUniform1f: (id, value) => gl.uniform1f(location(id), value),
    glShaderSource(id, count, strings, lengths) {
      const sizes = list(count, lengths);
      gl.shaderSource(objects[id], Array.from(list(count, strings), (at, i) => memory.text(at, sizes[i])).join(""));
    },
    glCompileShader: (id) => gl.compileShader(objects[id]),
    glAttachShader: (program, shader) => gl.attachShader(objects[program], objects[shader]),
    glLinkProgram: (id) => gl.linkProgram(objects[id]),
    glUseProgram: (id) => gl.useProgram(objects[id]),
    glGetActiveUniform(id, index, _, length, size, type, name) {
      const found = gl.getActiveUniform(objects[id], index);
      memory.ints[size >> 2] = found.size;
      memory.ints[type >> 2] = found.type;
      memory.put(name, found.name);
    },
    glGetUniformLocation: (id, name) => locations.push(gl.getUniformLocation(objects[id], memory.text(name))) - 1,
    glFramebufferTexture2D: (target, attachment, kind, id, level) => gl.framebufferTexture2D(target, attachment, kind, objects[id], level),
    glFramebufferRenderbuffer: (target, attachment, kind, id) => gl.framebufferRenderbuffer(target, attachment, kind, objects[id]),
    glDrawBuffers: (count, at) => gl.drawBuffers([...list(count, at)]),
    glClearBufferiv: (buffer, index, at) => gl.clearBufferiv(buffer, index, memory.ints, at >> 2),
    glInvalidateFramebuffer: (target, count, at) => gl.invalidateFramebuffer(target, [...list(count, at)]),
    glBufferData: (target, size, at, usage) => gl.bufferData(target, memory.bytes.subarray(at, at + size), usage),
    glTexSubImage2D: (target, level, x, y, width, height, format, type, at) => gl.texSubImage2D(target, level, x, y, width, height, format, type, ...pixels(type, at)),
    glTexSubImage3D: (target, level, x, y, z, width, height, depth, format, type, at) =>
      gl.texSubImage3D(target, level, x, y, z, width, height, depth, format, type, ...pixels(type, at)),
    glReadPixels: (x, y, width, height, format, type, at) => gl.readPixels(x, y, width, height, format, type, ...pixels(type, at)),
    glGetIntegerv(what, at) {
      const value = what === 0x821b ? 3 : gl.getParameter(what); // MAJOR_VERSION
      if (ArrayBuffer.isView(value)) memory.ints.set(value, at >> 2);
      else memory.ints[at >> 2] = value;
    },
  });
}
