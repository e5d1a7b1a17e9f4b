#include "engine/io/gltf_image.h"

#include <algorithm>
#include <span>

#include "engine/io/gltf_schema.h"

namespace sinew::gltf {
namespace {

using nlohmann::json;

bool is_png_or_jpeg(const std::vector<unsigned char>& bytes) {
  constexpr unsigned char png[] = {0x89, 'P', 'N', 'G'}, jpeg[] = {0xFF, 0xD8, 0xFF};
  const auto begins = [&](std::span<const unsigned char> with) {
    return bytes.size() > with.size() && std::equal(with.begin(), with.end(), bytes.begin());
  };
  return begins(png) || begins(jpeg);
}

void read_image_bytes(Document& document, const json& source, const std::string& place, Result<void>& memory,
                      EncodedImage& image) {
  const json* uri = find(source, {"uri"});
  const json* view = find(source, {"bufferView"});
  if (uri != nullptr && view != nullptr) document.problem("{}: has a uri and a bufferView; the uri is used", place);
  if (uri != nullptr) {
    auto fetched = document.fetch(uri->get_ref<const std::string&>());
    if (fetched)
      image.bytes = std::move(*fetched);
    else
      document.problem("{}: {}; drawn without it", place, fetched.error().message);
  } else if (view != nullptr) {
    const auto bytes = document.view(view->get<int>());
    memory = document.take_memory(bytes.size(), place);
    if (memory) image.bytes.assign(bytes.begin(), bytes.end());
  } else {
    document.problem("{}: has neither a uri nor a bufferView; drawn without it", place);
  }
}

}  // namespace

Result<std::vector<EncodedImage>> read_images(Document& document) {
  std::vector<EncodedImage> images;
  const json* list = find(document.source, {"images"});
  if (list == nullptr) return images;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string place = fmt::format("images/{}", i);
    EncodedImage image;
    if (const json* name = find((*list)[i], {"name"})) image.name = name->get<std::string>();
    Result<void> memory;
    read_image_bytes(document, (*list)[i], place, memory, image);
    if (!memory) return pass_on(std::move(memory));
    if (!image.bytes.empty() && !is_png_or_jpeg(image.bytes)) {
      document.problem("{}: is neither PNG nor JPEG; drawn without it", place);
      image.bytes.clear();
    }
    images.push_back(std::move(image));
  }
  return images;
}

}  // namespace sinew::gltf
