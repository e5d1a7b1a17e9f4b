#include "engine/gpu/gpu_deformer.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "engine/gpu/gpu_deformer_impl.h"
#include "engine/gpu/shader_code.h"

namespace sinew {
namespace {

constexpr vk::DeviceSize vertex_bytes = layout::words_per_vertex * sizeof(Word);
constexpr vk::DeviceSize output_bytes = layout::words_per_output * sizeof(Word);
/// A whole number of these vertices keeps every offset aligned to what any device may ask of a buffer offset.
constexpr std::size_t chunk_granularity = 256;
constexpr vk::DeviceSize tangent_bytes = sizeof(Word);

struct Binding {
  uint32_t number;
  const Buffer* buffer;
  const vk::raii::BufferView* view;
};

std::array<Binding, 5> shared_bindings(const GpuDeformer::Impl& d) {
  return {Binding{layout::binding_details, &d.detail_words, &d.detail_view},
          Binding{layout::binding_palette, &d.palette, &d.palette_view},
          Binding{layout::binding_morph_weights, &d.morph_weights, &d.morph_view},
          Binding{layout::binding_muscles, &d.muscle_words, &d.muscle_view},
          Binding{layout::binding_face, &d.face_words, &d.face_view}};
}

bool texel_buffers_fit(const VulkanDevice& vulkan, const PackedCharacter& packed, const CharacterMesh& mesh) {
  const std::size_t limit = vulkan.limits.maxTexelBufferElements;
  return packed.details.size() <= limit && mesh.palette.size() * layout::words_per_joint <= limit &&
         mesh.morph_slots.size() + face_signals <= limit && limit >= chunk_granularity * layout::words_per_vertex;
}

/// Vertices that one dispatch may cover.
std::size_t chunk_size(const VulkanDevice& vulkan, bool texel, std::size_t largest_range) {
  std::size_t range = vulkan.limits.maxStorageBufferRange;
  if (largest_range != 0) range = std::min(range, largest_range);
  std::size_t vertices = range / std::max(output_bytes, texel ? output_bytes : vertex_bytes);
  if (texel)
    vertices = std::min(vertices, vulkan.limits.maxTexelBufferElements / std::size_t{layout::words_per_vertex});
  vertices = std::min(vertices, vulkan.limits.maxComputeWorkGroupCount[0] * std::size_t{layout::workgroup_size});
  return std::max(vertices / chunk_granularity, std::size_t{1}) * chunk_granularity;
}

void create_buffers(GpuDeformer::Impl& d, const PackedCharacter& packed, const CharacterMesh& mesh) {
  using Usage = vk::BufferUsageFlagBits;
  VulkanDevice& vulkan = *d.vulkan;
  const auto usage = d.texel ? Usage::eUniformTexelBuffer : Usage::eStorageBuffer;
  d.vertex_words = vulkan.create_buffer(packed.vertices.size() * sizeof(Word), usage, MemoryUse::device);
  // Another age of a face may move a few vertices more (set_mesh).
  const std::size_t details = packed.details.size() + (mesh.face ? packed.details.size() / 8 + 1024 : 0);
  d.detail_words = vulkan.create_buffer(details * sizeof(Word), usage, MemoryUse::device);
  vulkan.upload(d.vertex_words, std::as_bytes(std::span(packed.vertices)));
  vulkan.upload(d.detail_words, std::as_bytes(std::span(packed.details)));
  const std::size_t joints = mesh.palette.size() * layout::words_per_joint;
  d.palette = vulkan.create_buffer(joints * sizeof(Word), usage, MemoryUse::upload);
  d.morph_slots = mesh.morph_slots.size();
  if (mesh.face) d.face = {face_sizes(mesh.face->rig), mesh.face->place, mesh.face->guides};
  const std::size_t weights = d.morph_slots + (d.face ? face_signals : 0);
  d.morph_weights = vulkan.create_buffer(weights * sizeof(float), usage, MemoryUse::upload);
  d.face_words = vulkan.create_buffer(d.face ? layout::words_per_face * sizeof(Word) : 0, usage, MemoryUse::upload);
  d.muscle_words = vulkan.create_buffer(d.muscles.size() * sizeof(layout::MuscleWord), usage, MemoryUse::upload);
  const auto output_usage = Usage::eStorageBuffer | Usage::eVertexBuffer | Usage::eTransferSrc;
  d.output = vulkan.create_buffer(d.vertices * output_bytes, output_usage, MemoryUse::device);
  d.has_tangents = !packed.tangents.empty();
  const std::size_t tangents = std::max<std::size_t>(packed.tangents.size(), 1) * tangent_bytes;
  d.tangent_words = vulkan.create_buffer(tangents, usage, MemoryUse::device);
  vulkan.upload(d.tangent_words, std::as_bytes(std::span(packed.tangents)));
  d.output_tangents = vulkan.create_buffer(tangents, output_usage, MemoryUse::device);
}

vk::raii::BufferView whole_view(const GpuDeformer::Impl& d, const Buffer& buffer, vk::Format format) {
  return {d.vulkan->device, vk::BufferViewCreateInfo({}, *buffer.buffer, format, 0, VK_WHOLE_SIZE)};
}

void create_views(GpuDeformer::Impl& d) {
  const auto view = [&](const Buffer& buffer, vk::Format format) { return whole_view(d, buffer, format); };
  d.detail_view = view(d.detail_words, vk::Format::eR32G32B32A32Uint);
  d.palette_view = view(d.palette, vk::Format::eR32G32B32A32Sfloat);
  d.morph_view = view(d.morph_weights, vk::Format::eR32Sfloat);
  d.muscle_view = view(d.muscle_words, vk::Format::eR32G32B32A32Sfloat);
  d.face_view = view(d.face_words, vk::Format::eR32G32B32A32Sfloat);
}

void create_layouts(GpuDeformer::Impl& d, std::size_t chunks) {
  const auto input = d.texel ? vk::DescriptorType::eUniformTexelBuffer : vk::DescriptorType::eStorageBuffer;
  std::vector<vk::DescriptorSetLayoutBinding> bindings;
  for (uint32_t number = 0; number < layout::deform_bindings; ++number) {
    const bool output = number == layout::binding_output || number == layout::binding_output_tangents;
    bindings.emplace_back(number, output ? vk::DescriptorType::eStorageBuffer : input, 1,
                          vk::ShaderStageFlagBits::eCompute);
  }
  const vk::raii::Device& device = d.vulkan->device;
  d.set_layout = vk::raii::DescriptorSetLayout(device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, sizeof(layout::DeformPush));
  d.pipeline_layout = vk::raii::PipelineLayout(device, vk::PipelineLayoutCreateInfo({}, *d.set_layout, push));
  const auto sets = static_cast<uint32_t>(chunks);
  const std::array sizes{vk::DescriptorPoolSize(input, sets * (layout::deform_bindings - 2)),
                         vk::DescriptorPoolSize(vk::DescriptorType::eStorageBuffer, sets * 2)};
  d.descriptor_pool = vk::raii::DescriptorPool(device, vk::DescriptorPoolCreateInfo({}, sets, sizes));
}

void create_pipeline(GpuDeformer::Impl& d, const PackedCharacter& packed, const GpuDeformerOptions& options) {
  const BulgeMode bulge = d.muscles.empty() ? BulgeMode::off : options.bulge;
  const std::array<uint32_t, 6> values{static_cast<uint32_t>(options.deformer),
                                       static_cast<uint32_t>(bulge),
                                       packed.has_morphs,
                                       packed.has_extra_influences,
                                       d.has_tangents,
                                       packed.has_face};
  const std::array entries{vk::SpecializationMapEntry(layout::constant_deformer, 0, 4),
                           vk::SpecializationMapEntry(layout::constant_bulge, 4, 4),
                           vk::SpecializationMapEntry(layout::constant_has_morphs, 8, 4),
                           vk::SpecializationMapEntry(layout::constant_has_extra_influences, 12, 4),
                           vk::SpecializationMapEntry(layout::constant_has_tangents, 16, 4),
                           vk::SpecializationMapEntry(layout::constant_has_face, 20, 4)};
  const vk::SpecializationInfo special(entries.size(), entries.data(), sizeof(values), values.data());
  const Shader full = d.texel ? Shader::deform_texel : Shader::deform_storage;
  const Shader bare = d.texel ? Shader::deform_bare_texel : Shader::deform_bare_storage;
  const vk::raii::ShaderModule module = d.vulkan->shader(options.bare ? bare : full);
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main",
                                                options.bare ? nullptr : &special);
  d.pipeline =
      vk::raii::Pipeline(d.vulkan->device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *d.pipeline_layout));
}

/// Binds one chunk's part of the vertices and of the output, and all of the rest.
void write_set(const GpuDeformer::Impl& d, const GpuDeformer::Impl::Chunk& chunk, std::size_t first) {
  std::vector<vk::DescriptorBufferInfo> buffers;
  buffers.reserve(layout::deform_bindings);
  std::vector<vk::WriteDescriptorSet> writes;
  const auto bind_buffer = [&](uint32_t number, const Buffer& buffer, vk::DeviceSize offset, vk::DeviceSize size) {
    buffers.emplace_back(*buffer.buffer, offset, size);
    writes.emplace_back(chunk.set, number, 0, 1, vk::DescriptorType::eStorageBuffer, nullptr, &buffers.back());
  };
  const auto bind_view = [&](uint32_t number, const vk::raii::BufferView& view) {
    vk::WriteDescriptorSet& write =
        writes.emplace_back(chunk.set, number, 0, 1, vk::DescriptorType::eUniformTexelBuffer, nullptr, nullptr);
    write.pTexelBufferView = &*view;
  };
  const std::size_t first_tangent = d.has_tangents ? first * tangent_bytes : 0;
  const std::size_t tangents = d.has_tangents ? chunk.vertices * tangent_bytes : VK_WHOLE_SIZE;
  if (d.texel) {
    bind_view(layout::binding_vertices, chunk.vertex_view);
    bind_view(layout::binding_tangents, chunk.tangent_view);
  } else {
    bind_buffer(layout::binding_vertices, d.vertex_words, first * vertex_bytes, chunk.vertices * vertex_bytes);
    bind_buffer(layout::binding_tangents, d.tangent_words, first_tangent, tangents);
  }
  for (const Binding& binding : shared_bindings(d)) {
    if (d.texel) {
      bind_view(binding.number, *binding.view);
    } else {
      bind_buffer(binding.number, *binding.buffer, 0, VK_WHOLE_SIZE);
    }
  }
  bind_buffer(layout::binding_output, d.output, first * output_bytes, chunk.vertices * output_bytes);
  bind_buffer(layout::binding_output_tangents, d.output_tangents, first_tangent, tangents);
  d.vulkan->device.updateDescriptorSets(writes, {});
}

void create_chunks(GpuDeformer::Impl& d, std::size_t size) {
  for (std::size_t first = 0; first < d.vertices; first += size) {
    GpuDeformer::Impl::Chunk& chunk = d.chunks.emplace_back();
    chunk.vertices = static_cast<uint32_t>(std::min(size, d.vertices - first));
    if (d.texel) {
      chunk.vertex_view = vk::raii::BufferView(
          d.vulkan->device, vk::BufferViewCreateInfo({}, *d.vertex_words.buffer, vk::Format::eR32G32B32A32Uint,
                                                     first * vertex_bytes, chunk.vertices * vertex_bytes));
      const std::size_t first_tangent = d.has_tangents ? first * tangent_bytes : 0;
      chunk.tangent_view = vk::raii::BufferView(
          d.vulkan->device,
          vk::BufferViewCreateInfo({}, *d.tangent_words.buffer, vk::Format::eR32G32B32A32Sfloat, first_tangent,
                                   d.has_tangents ? chunk.vertices * tangent_bytes : VK_WHOLE_SIZE));
    }
    chunk.set = d.vulkan->allocate_sets(d.descriptor_pool, std::array{*d.set_layout}).front();
    write_set(d, chunk, first);
  }
}

/// Vertices and details anew; a larger room for the details where theirs is too small, bound in its place.
void upload_shape(GpuDeformer::Impl& d, const PackedCharacter& packed) {
  const std::size_t size = packed.details.size() * sizeof(Word);
  if (size > d.detail_words.size) {
    // Half as much again: a region that is being drawn out grows many times.
    const auto usage = d.texel ? vk::BufferUsageFlagBits::eUniformTexelBuffer : vk::BufferUsageFlagBits::eStorageBuffer;
    Buffer larger = d.vulkan->create_buffer(size + size / 2, usage, MemoryUse::device);
    if (d.texel) d.detail_view = whole_view(d, larger, vk::Format::eR32G32B32A32Uint);
    d.detail_words = std::move(larger);
    std::size_t first = 0;
    for (const GpuDeformer::Impl::Chunk& chunk : d.chunks) {
      write_set(d, chunk, first);
      first += chunk.vertices;
    }
  }
  d.vulkan->upload(d.vertex_words, std::as_bytes(std::span(packed.vertices)));
  d.vulkan->upload(d.detail_words, std::as_bytes(std::span(packed.details)));
}

/// Storage ranges that are not split into chunks must fit the device whole.
Result<void> check_ranges(const VulkanDevice& vulkan, const PackedCharacter& packed, const CharacterMesh& mesh) {
  const std::size_t limit = vulkan.limits.maxStorageBufferRange;
  const std::size_t details = packed.details.size() * sizeof(Word);
  const std::size_t palette = mesh.palette.size() * layout::words_per_joint * sizeof(Word);
  if (details <= limit && palette <= limit) return {};
  return bad_input(
      "the character's joints, morph targets, face and muscle regions need {} bytes in one range, the device allows {}",
      std::max(details, palette), limit);
}

/// Details that grow still have to fit the device in one piece.
Result<void> check_details(const GpuDeformer::Impl& d, const PackedCharacter& packed) {
  const vk::PhysicalDeviceLimits& limits = d.vulkan->limits;
  const std::size_t words = packed.details.size() + packed.details.size() / 2;
  const std::size_t most = d.texel ? limits.maxTexelBufferElements : limits.maxStorageBufferRange / sizeof(Word);
  if (words <= most || packed.details.size() * sizeof(Word) <= d.detail_words.size) return {};
  return bad_input("the muscles' regions need {} words, the device allows {}", words, most);
}

}  // namespace

void GpuDeformer::Impl::record(const vk::raii::CommandBuffer& commands) const {
  commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
  for (const Chunk& chunk : chunks) {
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *pipeline_layout, 0, chunk.set, {});
    commands.pushConstants<layout::DeformPush>(*pipeline_layout, vk::ShaderStageFlagBits::eCompute, 0,
                                               layout::DeformPush{chunk.vertices});
    commands.dispatch((chunk.vertices + layout::workgroup_size - 1) / layout::workgroup_size, 1, 1);
  }
}

void deform_barrier(const vk::raii::CommandBuffer& commands) {
  using Stage = vk::PipelineStageFlagBits2;
  using Access = vk::AccessFlagBits2;
  const vk::MemoryBarrier2 barrier(Stage::eComputeShader, Access::eShaderStorageWrite,
                                   Stage::eVertexAttributeInput | Stage::eVertexShader | Stage::eCopy,
                                   Access::eVertexAttributeRead | Access::eShaderStorageRead | Access::eTransferRead);
  commands.pipelineBarrier2(vk::DependencyInfo({}, barrier));
}

GpuDeformer::GpuDeformer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
GpuDeformer::GpuDeformer(GpuDeformer&&) noexcept = default;
GpuDeformer& GpuDeformer::operator=(GpuDeformer&&) noexcept = default;
GpuDeformer::~GpuDeformer() = default;

std::size_t GpuDeformer::vertices() const { return impl_->vertices; }
std::size_t GpuDeformer::dispatches() const { return impl_->chunks.size(); }
BufferLayout GpuDeformer::layout() const { return impl_->texel ? BufferLayout::texel : BufferLayout::storage; }

Result<GpuDeformer> GpuDeformer::create(Device& device, const CharacterMesh& mesh, const RestShape& rest,
                                        std::span<const PlacedMuscle> muscles, const GpuDeformerOptions& options,
                                        std::span<const RigidDuplicate> duplicates) {
  auto packed = pack_character(mesh, rest, muscles, duplicates);
  if (!packed) return pass_on(std::move(packed));
  VulkanDevice& vulkan = device.vulkan();
  const bool fits = texel_buffers_fit(vulkan, *packed, mesh);
  auto impl = std::make_unique<Impl>();
  impl->vulkan = &vulkan;
  impl->vertices = packed->vertex_count();
  impl->muscles.assign(muscles.begin(), muscles.end());
  impl->duplicates.assign(duplicates.begin(), duplicates.end());
  impl->texel =
      options.layout == BufferLayout::texel || (options.layout == BufferLayout::automatic && vulkan.info.cpu && fits);
  if (!impl->texel)
    if (auto ok = check_ranges(vulkan, *packed, mesh); !ok) return pass_on(std::move(ok));
  const std::size_t size = chunk_size(vulkan, impl->texel, options.largest_range);
  auto created = vulkan_call("uploading the character", [&] {
    create_buffers(*impl, *packed, mesh);
    if (impl->texel) create_views(*impl);
    create_layouts(*impl, std::max<std::size_t>((impl->vertices + size - 1) / size, 1));
    create_pipeline(*impl, *packed, options);
    create_chunks(*impl, size);
  });
  if (!created) return pass_on(std::move(created));
  return GpuDeformer(std::move(impl));
}

Result<void> GpuDeformer::set_mesh(const CharacterMesh& mesh, const RestShape& rest) {
  const auto packed = pack_character(mesh, rest, impl_->muscles, impl_->duplicates);
  if (!packed) return tl::unexpected<Error>(packed.error());
  const std::size_t details = packed->details.size() * sizeof(Word), room = impl_->detail_words.size;
  if (packed->vertex_count() != impl_->vertices || details > room)
    return bad_input("another shape of the character needs {} vertices and {} bytes of details, there are {} and {}",
                     packed->vertex_count(), details, impl_->vertices, room);
  if (mesh.face) impl_->face = {face_sizes(mesh.face->rig), mesh.face->place, mesh.face->guides};
  return vulkan_call("uploading the character's shape", [&] { upload_shape(*impl_, *packed); });
}

Result<void> GpuDeformer::set_muscles(const CharacterMesh& mesh, const RestShape& rest,
                                      std::span<const PlacedMuscle> muscles) {
  if (muscles.size() != impl_->muscles.size())
    return bad_input("{} muscles in place of {}; the number has to stay", muscles.size(), impl_->muscles.size());
  if (!std::ranges::equal(muscles, impl_->muscles, is_packed_alike)) {
    const auto packed = pack_character(mesh, rest, muscles, impl_->duplicates);
    if (!packed) return tl::unexpected<Error>(packed.error());
    if (auto ok = check_details(*impl_, *packed); !ok) return ok;
    if (auto ok = vulkan_call("uploading the muscles", [&] { upload_shape(*impl_, *packed); }); !ok) return ok;
  }
  impl_->muscles.assign(muscles.begin(), muscles.end());
  return {};
}

void GpuDeformer::set_state(const GpuDeformState& state) {
  pack_palette(state.palette, impl_->palette.as<Vec4f>());
  const std::span<float> weights = impl_->morph_weights.as<float>();
  for (std::size_t i = 0; i < state.morph_weights.size(); ++i) weights[i] = static_cast<float>(state.morph_weights[i]);
  if (impl_->face) {
    const FaceState at_rest, &face = state.face ? *state.face : at_rest;
    for (std::size_t i = 0; i < face_signals; ++i)
      weights[impl_->morph_slots + i] = static_cast<float>(face.signals[i]);
    pack_face(*impl_->face, face, impl_->face_words.as<Vec4f>());
  }
  const std::span<layout::MuscleWord> words = impl_->muscle_words.as<layout::MuscleWord>();
  for (std::size_t i = 0; i < impl_->muscles.size(); ++i)
    words[i] = pack_muscle(impl_->muscles[i], state.activations[i]);
}

Result<void> GpuDeformer::run() {
  return vulkan_call("deforming",
                     [&] { impl_->vulkan->run([&](vk::raii::CommandBuffer& commands) { impl_->record(commands); }); });
}

namespace {

/// Copies words of a buffer that the pass has written to the host.
std::vector<Vec4f> read_words(GpuDeformer::Impl& d, const Buffer& from, std::size_t count) {
  std::vector<Vec4f> words(count);
  if (words.empty()) return words;
  const vk::DeviceSize size = count * sizeof(Word);
  if (d.readback.size < size)
    d.readback = d.vulkan->create_buffer(size, vk::BufferUsageFlagBits::eTransferDst, MemoryUse::readback);
  d.vulkan->run([&](vk::raii::CommandBuffer& commands) {
    deform_barrier(commands);
    commands.copyBuffer(*from.buffer, *d.readback.buffer, vk::BufferCopy(0, 0, size));
    const vk::MemoryBarrier2 to_host(vk::PipelineStageFlagBits2::eCopy, vk::AccessFlagBits2::eTransferWrite,
                                     vk::PipelineStageFlagBits2::eHost, vk::AccessFlagBits2::eHostRead);
    commands.pipelineBarrier2(vk::DependencyInfo({}, to_host));
  });
  std::memcpy(words.data(), d.readback.mapped, size);
  return words;
}

}  // namespace

Result<std::vector<Vec4f>> GpuDeformer::read_back() {
  return vulkan_call("reading vertices back",
                     [&] { return read_words(*impl_, impl_->output, impl_->vertices * layout::words_per_output); });
}

Result<std::vector<Vec4f>> GpuDeformer::read_back_tangents() {
  return vulkan_call("reading tangents back", [&] {
    return read_words(*impl_, impl_->output_tangents, impl_->has_tangents ? impl_->vertices : 0);
  });
}

}  // namespace sinew
