#include "engine/gpu/shader_compiler.h"

#include <cctype>
#include <list>
#include <sstream>

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "engine/core/files.h"

namespace sinew {
namespace {

/// The library's tables, made once and let go of at the program's end.
struct Compiler {
  Compiler() { glslang::InitializeProcess(); }
  ~Compiler() { glslang::FinalizeProcess(); }
};

/// Finds what a shader includes in one folder.
class FolderIncluder : public glslang::TShader::Includer {
 public:
  explicit FolderIncluder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  IncludeResult* includeLocal(const char* name, const char* /*from*/, std::size_t /*depth*/) override {
    auto text = read_file(folder_ / name);
    if (!text) return nullptr;
    const Bytes& kept = texts_.emplace_back(std::move(*text));
    return new IncludeResult(name, reinterpret_cast<const char*>(kept.data()), kept.size(), nullptr);
  }
  void releaseInclude(IncludeResult* result) override { delete result; }

 private:
  std::filesystem::path folder_;
  std::list<Bytes> texts_;  ///< the compiler reads them until it is done
};

Result<EShLanguage> stage_of(const std::filesystem::path& file) {
  if (file.extension() == ".vert") return EShLangVertex;
  if (file.extension() == ".frag") return EShLangFragment;
  if (file.extension() == ".comp") return EShLangCompute;
  return bad_input("{}: expected a shader's file to end in .vert, .frag or .comp", file.string());
}

/// What was wrong, from the compiler's log: its first error, which begins with file and line where it has a place.
tl::unexpected<Error> failed(const ShaderSource& source, const std::string& log) {
  constexpr std::string_view mark = "ERROR: ";
  std::istringstream lines(log);
  std::string line, said = "it does not compile";
  while (std::getline(lines, line))
    if (line.starts_with(mark)) {
      said = line.substr(mark.size(), line.find_last_not_of(' ') + 1 - mark.size());
      break;
    }
  const std::size_t colon = said.find(':');
  const bool has_place = colon != std::string::npos && colon + 1 < said.size() && std::isdigit(said[colon + 1]) != 0;
  return bad_input("{}{}", has_place ? "" : source.file + ": ", said);
}

}  // namespace

Result<std::vector<std::uint32_t>> compile_shader(const ShaderSource& source, const std::filesystem::path& folder) {
  static const Compiler compiler;
  const auto stage = stage_of(source.file);
  if (!stage) return tl::unexpected<Error>(stage.error());
  const auto text = read_file(folder / source.file);
  if (!text) return tl::unexpected<Error>(text.error());

  glslang::TShader shader(*stage);
  const char* words = reinterpret_cast<const char*>(text->data());
  const int length = static_cast<int>(text->size());
  const char* name = source.file.c_str();
  shader.setStringsWithLengthsAndNames(&words, &length, &name, 1);
  std::string preamble;
  for (const std::string& define : source.defines) preamble += "#define " + define + "\n";
  shader.setPreamble(preamble.c_str());
  constexpr int vulkan_glsl = 100, version_without_directive = 110;
  shader.setEnvInput(glslang::EShSourceGlsl, *stage, glslang::EShClientVulkan, vulkan_glsl);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
  constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  FolderIncluder includer(folder);
  if (!shader.parse(GetDefaultResources(), version_without_directive, false, messages, includer))
    return failed(source, shader.getInfoLog());
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages) || !program.mapIO()) return failed(source, program.getInfoLog());
  std::vector<std::uint32_t> code;
  glslang::GlslangToSpv(*program.getIntermediate(*stage), code);
  return code;
}

Result<ShaderSet> compile_shaders(const std::filesystem::path& folder, TaskWatch& watch) {
  ShaderSet set;
  watch.begin(shader_sources().size());
  for (const ShaderSource& source : shader_sources()) {
    if (auto ok = watch.check(); !ok) return pass_on(std::move(ok));
    auto code = compile_shader(source, folder);
    if (!code) return pass_on(std::move(code));
    set[source.shader] = std::move(*code);
    watch.advance();
  }
  return set;
}

}  // namespace sinew
