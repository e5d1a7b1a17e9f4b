#include "engine/gpu/device.h"

#include <malloc.h>

#include <algorithm>
#include <array>

#include "engine/core/text.h"
#include "engine/gpu/vulkan.h"

namespace sinew {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

/// llvmpipe allocates and frees tens of megabytes a frame; without these thresholds glibc gives them back to the kernel
/// every time, and page faults cost half of a large draw. Harmless elsewhere.
void keep_freed_memory() {
  mallopt(M_TRIM_THRESHOLD, 2'000'000'000);
  mallopt(M_TOP_PAD, 64 << 20);
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
}

std::string version_text(uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

std::string type_name(vk::PhysicalDeviceType type) {
  switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
      return "discrete";
    case vk::PhysicalDeviceType::eIntegratedGpu:
      return "integrated";
    case vk::PhysicalDeviceType::eVirtualGpu:
      return "virtual";
    case vk::PhysicalDeviceType::eCpu:
      return "cpu";
    default:
      return "other";
  }
}

std::optional<uint32_t> find_queue_family(const vk::raii::PhysicalDevice& physical) {
  const auto families = physical.getQueueFamilyProperties();
  constexpr auto needed = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
  for (uint32_t i = 0; i < families.size(); ++i)
    if ((families[i].queueFlags & needed) == needed) return i;
  return std::nullopt;
}

std::string refusal(const vk::raii::PhysicalDevice& physical) {
  const uint32_t version = physical.getProperties().apiVersion;
  if (version < VK_API_VERSION_1_3) return fmt::format("it has Vulkan {}, 1.3 is needed", version_text(version));
  if (!find_queue_family(physical)) return "it has no queue for both graphics and compute";
  const auto features = physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan13Features>();
  const auto& core13 = features.get<vk::PhysicalDeviceVulkan13Features>();
  if (!core13.dynamicRendering || !core13.synchronization2 || !core13.maintenance4)
    return "it lacks dynamic rendering, synchronization2 or maintenance4";
  return {};
}

DeviceInfo describe(const vk::raii::PhysicalDevice& physical) {
  const auto properties = physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
  const auto& core = properties.get<vk::PhysicalDeviceProperties2>().properties;
  const auto& driver = properties.get<vk::PhysicalDeviceDriverProperties>();
  DeviceInfo info;
  info.name = core.deviceName.data();
  info.type = type_name(core.deviceType);
  info.api = version_text(core.apiVersion);
  info.driver = fmt::format("{} {}", driver.driverName.data(), driver.driverInfo.data());
  info.cpu = core.deviceType == vk::PhysicalDeviceType::eCpu;
  info.refused = refusal(physical);
  return info;
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  auto& vulkan = *static_cast<VulkanDevice*>(user);
  const std::lock_guard lock(vulkan.message_mutex);
  vulkan.messages.emplace_back(data->pMessage);
  return VK_FALSE;
}

vk::DebugUtilsMessengerCreateInfoEXT messenger_info(VulkanDevice& vulkan) {
  using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
  vk::DebugUtilsMessengerCreateInfoEXT info;
  info.messageSeverity = Severity::eWarning | Severity::eError;
  info.messageType = vk::DebugUtilsMessageTypeFlagBitsEXT::eValidation;
  info.pfnUserCallback = &on_message;
  info.pUserData = &vulkan;
  return info;
}

bool has_validation_layer(const vk::raii::Context& context) {
  const auto layers = context.enumerateInstanceLayerProperties();
  return std::any_of(layers.begin(), layers.end(), [](const vk::LayerProperties& layer) {
    return std::string_view(layer.layerName) == validation_layer;
  });
}

/// Throws vk::SystemError where no driver can be loaded.
void create_instance(VulkanDevice& vulkan, bool validate, const std::vector<std::string>& surface_extensions = {}) {
  vk::ApplicationInfo application("sinew", 1, "sinew", 1, VK_API_VERSION_1_3);
  vk::InstanceCreateInfo info({}, &application);
  const std::array layers{validation_layer};
  std::vector<const char*> extensions;
  for (const std::string& extension : surface_extensions) extensions.push_back(extension.c_str());
  const std::array checks{vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
  vk::DebugUtilsMessengerCreateInfoEXT messages = messenger_info(vulkan);
  vk::ValidationFeaturesEXT features(checks);
  if (validate) {
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    info.setPEnabledLayerNames(layers);
    features.pNext = &messages;
    info.pNext = &features;
  }
  info.setPEnabledExtensionNames(extensions);
  vulkan.instance = vk::raii::Instance(vulkan.context, info);
  if (validate) vulkan.messenger = vk::raii::DebugUtilsMessengerEXT(vulkan.instance, messenger_info(vulkan));
}

bool has_swapchain(const vk::raii::PhysicalDevice& physical) {
  const auto extensions = physical.enumerateDeviceExtensionProperties();
  return std::any_of(extensions.begin(), extensions.end(), [](const vk::ExtensionProperties& extension) {
    return std::string_view(extension.extensionName) == VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  });
}

int preference(const DeviceInfo& info) {
  if (info.type == "discrete") return 0;
  if (info.type == "integrated") return 1;
  if (info.type == "virtual") return 2;
  return info.cpu ? 4 : 3;
}

std::string listing(const std::vector<DeviceInfo>& devices) {
  std::string text;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    text += fmt::format("\n  {}: {} ({})", i, devices[i].name, devices[i].type);
    if (!devices[i].refused.empty()) text += ", refused: " + devices[i].refused;
  }
  return text.empty() ? "\n  none" : text;
}

/// Index into `devices` of the one that is meant.
Result<std::size_t> choose(const std::vector<DeviceInfo>& devices, const std::string& wanted) {
  std::optional<std::size_t> chosen;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const auto index = parse_integer(wanted);
    const bool meant =
        index ? *index == static_cast<long long>(i) : lower(devices[i].name).find(lower(wanted)) != std::string::npos;
    if (!meant) continue;
    if (!wanted.empty() && !devices[i].refused.empty())
      return failure(ErrorKind::no_device, "device \"{}\" cannot be used: {}", devices[i].name, devices[i].refused);
    if (!devices[i].refused.empty()) continue;
    if (!chosen || preference(devices[i]) < preference(devices[*chosen])) chosen = i;
  }
  if (chosen) return *chosen;
  if (wanted.empty())
    return failure(ErrorKind::no_device,
                   "no Vulkan 1.3 device can be used; found:{}\nOn Debian, mesa-vulkan-drivers "
                   "brings one that runs on the CPU.",
                   listing(devices));
  return failure(ErrorKind::no_device, "no Vulkan device is called \"{}\"; there are:{}", wanted, listing(devices));
}

void create_logical_device(VulkanDevice& vulkan, bool for_windows) {
  vulkan.queue_family = *find_queue_family(vulkan.physical);
  vulkan.limits = vulkan.physical.getProperties().limits;
  vulkan.anisotropy = vulkan.physical.getFeatures().samplerAnisotropy;
  vulkan.sample_shading = vulkan.physical.getFeatures().sampleRateShading;
  const float priority = 1.0f;
  const vk::DeviceQueueCreateInfo queue({}, vulkan.queue_family, 1, &priority);
  vk::PhysicalDeviceVulkan13Features core13;
  core13.dynamicRendering = true;
  core13.synchronization2 = true;
  core13.maintenance4 = true;
  vk::PhysicalDeviceFeatures2 features;
  features.features.samplerAnisotropy = vulkan.anisotropy;
  features.features.sampleRateShading = vulkan.sample_shading;
  features.pNext = &core13;
  const std::array swapchain{VK_KHR_SWAPCHAIN_EXTENSION_NAME};
  vk::DeviceCreateInfo info({}, queue);
  if (for_windows) info.setPEnabledExtensionNames(swapchain);
  info.pNext = &features;
  vulkan.device = vk::raii::Device(vulkan.physical, info);
  vulkan.queue = vk::raii::Queue(vulkan.device, vulkan.queue_family, 0);
  vulkan.pool = vk::raii::CommandPool(
      vulkan.device, vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eTransient, vulkan.queue_family));
}

std::vector<DeviceInfo> describe_all(const vk::raii::PhysicalDevices& physical) {
  std::vector<DeviceInfo> devices;
  for (const auto& each : physical) devices.push_back(describe(each));
  return devices;
}

tl::unexpected<Error> no_vulkan(const vk::SystemError& error) {
  return failure(ErrorKind::no_device,
                 "Vulkan cannot start ({}); is a driver installed? On Debian, mesa-vulkan-drivers "
                 "brings one that runs on the CPU.",
                 error.what());
}

}  // namespace

Device::Device(std::unique_ptr<VulkanDevice> vulkan) : vulkan_(std::move(vulkan)) {}
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;
Device::~Device() = default;

const DeviceInfo& Device::info() const { return vulkan_->info; }

std::vector<std::string> Device::validation_messages() const {
  const std::lock_guard lock(vulkan_->message_mutex);
  return vulkan_->messages;
}

void Device::use_shaders(std::shared_ptr<const ShaderSet> shaders) { vulkan_->shaders = std::move(shaders); }

Result<Device> Device::create(const DeviceOptions& options) {
  keep_freed_memory();
  try {
    auto vulkan = std::make_unique<VulkanDevice>();
    vulkan->shaders = options.shaders;
    if (options.validate && !has_validation_layer(vulkan->context))
      return failure(ErrorKind::no_device, "--validate needs the layer {} (Debian: vulkan-validationlayers)",
                     validation_layer);
    create_instance(*vulkan, options.validate, options.surface_extensions);
    const vk::raii::PhysicalDevices physical(vulkan->instance);
    const auto devices = describe_all(physical);
    const auto chosen = choose(devices, options.wanted);
    if (!chosen) return tl::unexpected<Error>(chosen.error());
    vulkan->physical = physical[*chosen];
    vulkan->info = devices[*chosen];
    const bool for_windows = !options.surface_extensions.empty();
    if (for_windows && !has_swapchain(vulkan->physical))
      return failure(ErrorKind::no_device, "device \"{}\" cannot show pictures in a window; sinew render needs none",
                     vulkan->info.name);
    create_logical_device(*vulkan, for_windows);
    return Device(std::move(vulkan));
  } catch (const vk::SystemError& error) {
    return no_vulkan(error);
  }
}

Result<std::vector<DeviceInfo>> Device::list() {
  try {
    VulkanDevice vulkan;
    create_instance(vulkan, false);
    return describe_all(vk::raii::PhysicalDevices(vulkan.instance));
  } catch (const vk::SystemError& error) {
    return no_vulkan(error);
  }
}

}  // namespace sinew
