// SPDX-License-Identifier: MIT
// The OpenGL 3.3 core functions we call, as one plain table that a host's loader fills.
//
// A table belongs to one context: pass it along by reference, call through it only while that
// context is current on the calling thread. Nothing links to libGL; a direct call of a gl function
// fails at link time, which is meant.
#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "render/failure.hpp"

// The prototypes are used for their types only.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES 1
#endif
#include <GL/glcorearb.h>

// Every name must be in OpenGL 3.3 core: some loaders (OSMesa's) give an address for any name.
// clang-format off
#define VIDES_GL_FUNCTIONS(X)                                                                     \
  X(ActiveTexture) X(AttachShader) X(BeginQuery) X(BindBuffer) X(BindBufferBase)                  \
  X(BindBufferRange) X(BindFramebuffer) X(BindRenderbuffer) X(BindSampler) X(BindTexture)         \
  X(BindVertexArray) X(BlendEquation) X(BlendEquationSeparate) X(BlendFunc) X(BlendFuncSeparate)  \
  X(BlitFramebuffer) X(BufferData) X(BufferSubData) X(CheckFramebufferStatus) X(Clear)            \
  X(ClearColor) X(ClearDepth) X(ClearStencil) X(ColorMask) X(CompileShader) X(CreateProgram)      \
  X(CreateShader) X(CullFace) X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram)             \
  X(DeleteQueries) X(DeleteRenderbuffers) X(DeleteSamplers) X(DeleteShader) X(DeleteTextures)     \
  X(DeleteVertexArrays) X(DepthFunc) X(DepthMask) X(DepthRange) X(DetachShader) X(Disable)        \
  X(DisableVertexAttribArray) X(DrawArrays) X(DrawArraysInstanced) X(DrawBuffers)                 \
  X(DrawElements) X(DrawElementsBaseVertex) X(DrawElementsInstanced)                              \
  X(DrawElementsInstancedBaseVertex) X(Enable) X(EnableVertexAttribArray) X(EndQuery) X(Finish)   \
  X(Flush) X(FramebufferRenderbuffer) X(FramebufferTexture2D) X(FrontFace) X(GenBuffers)          \
  X(GenFramebuffers) X(GenQueries) X(GenRenderbuffers) X(GenSamplers) X(GenTextures)              \
  X(GenVertexArrays) X(GenerateMipmap) X(GetActiveUniform) X(GetAttribLocation)                   \
  X(GetBufferSubData) X(GetError) X(GetFloatv) X(GetIntegerv) X(GetProgramInfoLog)                \
  X(GetProgramiv) X(GetQueryObjectui64v) X(GetQueryObjectuiv) X(GetShaderInfoLog) X(GetShaderiv)  \
  X(GetString) X(GetStringi) X(GetUniformBlockIndex) X(GetUniformLocation) X(IsEnabled)           \
  X(LineWidth) X(LinkProgram) X(MapBufferRange) X(MultiDrawArrays) X(PixelStorei) X(PointSize)    \
  X(PolygonMode) X(PolygonOffset) X(PrimitiveRestartIndex) X(ReadBuffer) X(ReadPixels)            \
  X(RenderbufferStorage) X(RenderbufferStorageMultisample) X(SamplerParameteri) X(Scissor)        \
  X(ShaderSource) X(StencilFunc) X(StencilMask) X(StencilOp) X(TexBuffer) X(TexImage2D)           \
  X(TexParameteri) X(TexSubImage2D) X(Uniform1f) X(Uniform1i) X(Uniform2f) X(Uniform2fv)          \
  X(Uniform2i) X(Uniform3f) X(Uniform3fv) X(Uniform4f) X(Uniform4fv) X(UniformBlockBinding)       \
  X(UniformMatrix3fv) X(UniformMatrix4fv) X(UnmapBuffer) X(UseProgram) X(VertexAttribDivisor)     \
  X(VertexAttribIPointer) X(VertexAttribPointer) X(Viewport)
// clang-format on

namespace vides {

// What one context allows, read once when its table is filled.
struct GlLimits {
  int major = 0;           // version of the context, e.g. 4
  int minor = 0;           // e.g. 5
  std::string version;     // as the driver says it, e.g. "4.5 (Core Profile) Mesa 22.3.6"
  std::string renderer;    // e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
  int maxWidth = 0;        // pixels of the largest picture: the least of viewport,
  int maxHeight = 0;       // renderbuffer and texture limits
  int maxTextureSize = 0;  // pixels along a side of a texture
  int maxSamples = 0;      // samples a pixel of a renderbuffer
};

struct Gl {
#define VIDES_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
  VIDES_GL_FUNCTIONS(VIDES_GL_MEMBER)
#undef VIDES_GL_MEMBER
  GlLimits limits;
};

using GlFunction = void (*)();
// The address of the function called `name` ("glClear"), or null.
using GlLoader = std::function<GlFunction(const char* name)>;

// Fills a table for the current context. The error is a sentence: no context, a version below 3.3
// ("OpenGL 3.3 is needed; this is 2.1 (Mesa 22.3.6)"), or the names that the driver lacks.
tl::expected<Gl, std::string> loadGl(const GlLoader& loader);

// Nothing, or a sentence "WHAT: OpenGL reports NAME": empties the context's list of errors.
tl::expected<void, std::string> checkGl(const Gl& gl, const char* what);

}  // namespace vides
