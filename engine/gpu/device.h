#pragma once
/// The Vulkan device that everything runs on. Vulkan's own types stay behind this header (engine/gpu/vulkan.h).

#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/gpu/shader_code.h"

namespace sinew {

/// What users and scripts are told about a device.
struct DeviceInfo {
  std::string name;
  std::string type;    ///< "discrete", "integrated", "virtual", "cpu" or "other"
  std::string api;     ///< "1.3.230"
  std::string driver;  ///< the driver's name and version
  bool cpu = false;
  std::string refused;  ///< why it cannot be used, or empty
};

struct DeviceOptions {
  std::string wanted;     ///< index, or a part of the name, letter case ignored; empty: the fastest kind there is
  bool validate = false;  ///< run with the validation layer's core and synchronisation checks
  /// Instance extensions of a window system. Not empty: the device can show pictures in its windows.
  std::vector<std::string> surface_extensions = {};
  /// In place of those that the program carries; null: none.
  std::shared_ptr<const ShaderSet> shaders = nullptr;
};

struct VulkanDevice;

/// A device with one queue for graphics, compute and transfer. Not thread-safe.
class Device {
 public:
  /// Sets the process' malloc to keep freed memory: on CPU devices half of a large frame was page faults.
  /// Fails as no_device, with every device that was found and why it was refused.
  static Result<Device> create(const DeviceOptions& options);

  /// All devices, usable or not. Fails as no_device where Vulkan itself cannot start.
  static Result<std::vector<DeviceInfo>> list();

  Device(Device&&) noexcept;
  Device& operator=(Device&&) noexcept;
  ~Device();

  const DeviceInfo& info() const;

  /// What the validation layer has said so far; always empty without DeviceOptions::validate.
  std::vector<std::string> validation_messages() const;

  /// DeviceOptions::shaders of what is made on the device from now on.
  void use_shaders(std::shared_ptr<const ShaderSet> shaders);

  VulkanDevice& vulkan() { return *vulkan_; }

 private:
  explicit Device(std::unique_ptr<VulkanDevice> vulkan);
  std::unique_ptr<VulkanDevice> vulkan_;
};

}  // namespace sinew
