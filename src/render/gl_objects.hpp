// SPDX-License-Identifier: MIT
// OpenGL objects that free themselves: handle, buffer, vertex array, texture, shader program.
//
// Each remembers the table it was made with; that table must outlive it (a host's does as long as
// the host), and the table's context must be current wherever an object is made, used or destroyed.
// All move, none copies; a default-constructed or moved-from one holds nothing (id 0).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

#include "render/failure.hpp"
#include "render/gl_functions.hpp"

namespace vides {

// One name from a glGen… function, given back by the glDelete… function of the same kind.
template <auto Generate, auto Delete>
class GlHandle {
 public:
  GlHandle() = default;
  explicit GlHandle(const Gl& gl) : gl_(&gl) { (gl.*Generate)(1, &id_); }
  GlHandle(GlHandle&& other) noexcept
      : gl_(std::exchange(other.gl_, nullptr)), id_(std::exchange(other.id_, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlHandle() {
    if (id_ != 0) (gl_->*Delete)(1, &id_);
  }

  GLuint id() const { return id_; }
  // The table it was made with; only for one that holds something.
  const Gl& gl() const { return *gl_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
};

using BufferHandle = GlHandle<&Gl::GenBuffers, &Gl::DeleteBuffers>;
using VertexArray = GlHandle<&Gl::GenVertexArrays, &Gl::DeleteVertexArrays>;
using TextureHandle = GlHandle<&Gl::GenTextures, &Gl::DeleteTextures>;
using FramebufferHandle = GlHandle<&Gl::GenFramebuffers, &Gl::DeleteFramebuffers>;
using RenderbufferHandle = GlHandle<&Gl::GenRenderbuffers, &Gl::DeleteRenderbuffers>;

// Bytes on the GPU, bound to one target (GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER,
// GL_UNIFORM_BUFFER…). An element array's binding belongs to the vertex array bound at the time.
class Buffer {
 public:
  Buffer() = default;
  Buffer(const Gl& gl, GLenum target) : handle_(gl), target_(target) {}

  void bind() const { handle_.gl().BindBuffer(target_, handle_.id()); }
  // Replaces all of it. `usage`: GL_STATIC_DRAW, GL_DYNAMIC_DRAW, GL_STREAM_DRAW. Leaves it bound.
  void upload(std::span<const std::byte> bytes, GLenum usage);
  // Makes it `size` bytes long; they hold anything. Leaves it bound.
  void reserve(std::size_t size, GLenum usage);
  // Replaces a part that lies inside what was uploaded (asserted). Leaves it bound.
  void update(std::size_t offset, std::span<const std::byte> bytes);

  GLuint id() const { return handle_.id(); }
  std::size_t size() const { return size_; }  // bytes

 private:
  BufferHandle handle_;
  GLenum target_ = 0;
  std::size_t size_ = 0;
};

enum class TextureFilter { kNearest, kLinear };

// kColour: four bytes a pixel, plain sRGB and alpha. kCoverage: one byte, the alpha of white.
enum class TextureKind { kColour, kCoverage };

// A two-dimensional texture, clamped at its edges, without mipmaps.
class Texture {
 public:
  Texture() = default;
  // `pixels`: width · height · 4 bytes (kCoverage: · 1), rows one after the other, row 0 at v = 0;
  // or empty, which leaves the contents undefined. Error: a side that is not positive or beyond the
  // GPU's limit.
  static tl::expected<Texture, std::string> create(const Gl& gl, int width, int height,
                                                   std::span<const std::uint8_t> pixels,
                                                   TextureFilter filter = TextureFilter::kLinear,
                                                   TextureKind kind = TextureKind::kColour);

  // Replaces all pixels; the size stays. `pixels` as in create, not empty.
  void update(std::span<const std::uint8_t> pixels);

  GLuint id() const { return handle_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }
  explicit operator bool() const { return static_cast<bool>(handle_); }

 private:
  TextureHandle handle_;
  TextureKind kind_ = TextureKind::kColour;
  int width_ = 0;
  int height_ = 0;
};

// A vertex and a fragment shader, compiled and linked.
class ShaderProgram {
 public:
  ShaderProgram() = default;
  // The error holds `name` and the driver's log.
  static tl::expected<ShaderProgram, std::string> build(const Gl& gl, std::string_view name,
                                                        std::string_view vertexSource,
                                                        std::string_view fragmentSource);
  ShaderProgram(ShaderProgram&& other) noexcept
      : gl_(std::exchange(other.gl_, nullptr)), id_(std::exchange(other.id_, 0)) {}
  ShaderProgram& operator=(ShaderProgram&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~ShaderProgram() {
    if (id_ != 0) gl_->DeleteProgram(id_);
  }

  void use() const { gl_->UseProgram(id_); }
  // The place of a uniform; asserts that the program has it. Look it up once, not at each draw.
  GLint uniform(const char* name) const;
  GLuint id() const { return id_; }

 private:
  ShaderProgram(const Gl& gl, GLuint id) : gl_(&gl), id_(id) {}

  const Gl* gl_ = nullptr;
  GLuint id_ = 0;
};

}  // namespace vides
