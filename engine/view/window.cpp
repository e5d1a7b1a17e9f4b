#include "engine/view/window.h"

#include <cmath>
#include <cstring>

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

#include "engine/gpu/vulkan.h"
#include "engine/render/renderer_image.h"
#include "engine/view/kept_panels.h"
#include "engine/view/keyboard.h"
#include "engine/view/swapchain.h"

namespace sinew {
namespace {

constexpr float font_size = 15.0f;
/// The panels need so much; whoever asks for less gets it.
constexpr PictureSize least_size{800, 480};
/// Parts of the interface that are drawn by themselves in one frame: their buffers are used in turn.
constexpr std::uint32_t most_interface_draws = 16;

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason was given";
}

/// 2 where the system itself counts in units of two pixels.
float pixels_per_system_unit(GLFWwindow* window) {
  int width = 0, height = 0, across = 0, down = 0;
  glfwGetWindowSize(window, &width, &height);
  glfwGetFramebufferSize(window, &across, &down);
  return width > 0 && across > 0 ? static_cast<float>(across) / static_cast<float>(width) : 1.0f;
}

/// System units that the interface has to make larger by itself: where the system counts in pixels.
float own_scale(GLFWwindow* window) {
  float across = 1.0f, down = 1.0f;
  glfwGetWindowContentScale(window, &across, &down);
  return std::max(1.0f, across / pixels_per_system_unit(window));
}

}  // namespace

Result<WindowSystem> WindowSystem::start() {
  if (!glfwInit())
    return failure(ErrorKind::no_device,
                   "no window can be opened ({}); sinew render makes pictures and films without a display",
                   last_glfw_error());
  if (!glfwVulkanSupported()) {
    glfwTerminate();
    return failure(ErrorKind::no_device, "the window system finds no Vulkan loader (Debian: libvulkan1)");
  }
  return WindowSystem();
}

WindowSystem::~WindowSystem() {
  if (running_) glfwTerminate();
}

std::vector<std::string> WindowSystem::surface_extensions() const {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  return {names, names + count};
}

struct Window::Impl {
  VulkanDevice* vulkan = nullptr;
  GLFWwindow* window = nullptr;
  std::vector<std::filesystem::path> dropped;
  std::vector<KeyPress> presses;
  bool events = true;
  bool interface_made = false;
  vk::raii::SurfaceKHR surface = nullptr;
  vk::raii::DescriptorPool pool = nullptr;
  std::unique_ptr<Swapchain> swapchain;
  KeptPanels panels;
  /// Of the system's own units, which are pixels on some systems, and which the interface would be too small in.
  float content_scale = 1.0f;

  ~Impl() {
    if (vulkan && *vulkan->device) vulkan->device.waitIdle();
    if (interface_made) {
      ImGui_ImplVulkan_Shutdown();
      ImGui_ImplGlfw_Shutdown();
      ImGui::DestroyContext();
    }
    swapchain.reset();
    pool = nullptr;
    surface = nullptr;
    if (window) glfwDestroyWindow(window);
  }

  void make_interface(const WindowOptions& options);
};

void Window::Impl::make_interface(const WindowOptions& options) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  // Letters are made as fine as the display's pixels, and laid out in units.
  const float fineness = content_scale * pixels_per_system_unit(window);
  if (!options.font.empty()) io.Fonts->AddFontFromFileTTF(options.font.c_str(), font_size * fineness);
  io.FontGlobalScale = 1.0f / fineness;
  ImGui_ImplGlfw_InitForVulkan(window, true);

  const std::array sizes{vk::DescriptorPoolSize(vk::DescriptorType::eCombinedImageSampler, 8)};
  pool = vk::raii::DescriptorPool(
      vulkan->device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 8, sizes));
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = *vulkan->instance;
  info.PhysicalDevice = *vulkan->physical;
  info.Device = *vulkan->device;
  info.QueueFamily = vulkan->queue_family;
  info.Queue = *vulkan->queue;
  info.DescriptorPool = *pool;
  info.MinImageCount = 2;
  info.ImageCount = most_interface_draws;
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  ImGui_ImplVulkan_Init(&info, swapchain->render_pass());
  interface_made = true;
  vulkan->run([](vk::raii::CommandBuffer& commands) { ImGui_ImplVulkan_CreateFontsTexture(*commands); });
  ImGui_ImplVulkan_DestroyFontUploadObjects();
}

Window::Window(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Window::Window(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::create(WindowSystem&, Device& device, const WindowOptions& options) {
  auto impl = std::make_unique<Impl>();
  impl->vulkan = &device.vulkan();
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, options.in_units ? GLFW_TRUE : GLFW_FALSE);
  impl->window = glfwCreateWindow(options.size.width, options.size.height, options.title.c_str(), nullptr, nullptr);
  if (!impl->window)
    return failure(ErrorKind::no_device, "no window can be opened ({}); sinew render needs none", last_glfw_error());
  impl->content_scale = own_scale(impl->window);
  PictureSize given;
  glfwGetWindowSize(impl->window, &given.width, &given.height);
  const auto least = [&](int units, int asked) {
    return std::min(static_cast<int>(std::lround(impl->content_scale * static_cast<float>(units))), asked);
  };
  glfwSetWindowSizeLimits(impl->window, least(least_size.width, given.width), least(least_size.height, given.height),
                          GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwSetWindowUserPointer(impl->window, impl.get());
  glfwSetDropCallback(impl->window, [](GLFWwindow* window, int count, const char** paths) {
    auto& self = *static_cast<Impl*>(glfwGetWindowUserPointer(window));
    self.dropped.insert(self.dropped.end(), paths, paths + count);
    self.events = true;
  });
  const auto stir = [](GLFWwindow* window) { static_cast<Impl*>(glfwGetWindowUserPointer(window))->events = true; };
  static const auto stirred = stir;
  glfwSetWindowRefreshCallback(impl->window, stirred);
  glfwSetCursorPosCallback(impl->window, [](GLFWwindow* window, double, double) { stirred(window); });
  glfwSetMouseButtonCallback(impl->window, [](GLFWwindow* window, int, int, int) { stirred(window); });
  glfwSetScrollCallback(impl->window, [](GLFWwindow* window, double, double) { stirred(window); });
  glfwSetKeyCallback(impl->window, [](GLFWwindow* window, int code, int, int action, int modifiers) {
    stirred(window);
    const bool shift = modifiers & GLFW_MOD_SHIFT;
    const auto key = keyboard_key(code, shift);
    if (!key || action == GLFW_RELEASE) return;
    static_cast<Impl*>(glfwGetWindowUserPointer(window))
        ->presses.push_back({*key, (modifiers & GLFW_MOD_CONTROL) != 0, shift, action == GLFW_REPEAT});
  });
  glfwSetWindowCloseCallback(impl->window, stirred);
  glfwSetWindowFocusCallback(impl->window, [](GLFWwindow* window, int) { stirred(window); });
  glfwSetFramebufferSizeCallback(impl->window, [](GLFWwindow* window, int, int) { stirred(window); });

  VkSurfaceKHR surface = nullptr;
  if (glfwCreateWindowSurface(*impl->vulkan->instance, impl->window, nullptr, &surface) != VK_SUCCESS)
    return failure(ErrorKind::no_device,
                   "device \"{}\" cannot show pictures in this window ({}); sinew render needs none",
                   device.info().name, last_glfw_error());
  auto made = vulkan_call("opening the window", [&] {
    impl->surface = vk::raii::SurfaceKHR(impl->vulkan->instance, surface);
    if (!impl->vulkan->physical.getSurfaceSupportKHR(impl->vulkan->queue_family, *impl->surface))
      throw vk::FeatureNotPresentError("its queue cannot show pictures");
    int width = 0, height = 0;
    glfwGetFramebufferSize(impl->window, &width, &height);
    impl->swapchain = std::make_unique<Swapchain>(*impl->vulkan, *impl->surface, options.uncapped);
    impl->swapchain->resize(width, height);
    impl->make_interface(options);
  });
  if (!made) return pass_on(std::move(made));
  return Window(std::move(impl));
}

bool Window::is_closing() const { return glfwWindowShouldClose(impl_->window); }
void Window::close() { glfwSetWindowShouldClose(impl_->window, GLFW_TRUE); }
void Window::keep_open() { glfwSetWindowShouldClose(impl_->window, GLFW_FALSE); }
void Window::set_clipboard(const std::string& text) { glfwSetClipboardString(impl_->window, text.c_str()); }

PictureSize Window::size() const {
  PictureSize size{0, 0};
  glfwGetFramebufferSize(impl_->window, &size.width, &size.height);
  return size;
}

double Window::pixels_per_unit() const {
  return static_cast<double>(impl_->content_scale * pixels_per_system_unit(impl_->window));
}

void Window::take_events(bool wait, double seconds) {
  if (wait)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
}

bool Window::had_events() { return std::exchange(impl_->events, false); }

std::vector<std::filesystem::path> Window::take_dropped_files() { return std::exchange(impl_->dropped, {}); }

std::vector<KeyPress> Window::take_key_presses() {
  std::vector<KeyPress> presses = std::exchange(impl_->presses, {});
  if (ImGui::GetIO().WantTextInput) presses.clear();
  // A menu or question has the keys; the window can still be closed.
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
    std::erase_if(presses, [](const KeyPress& press) { return press.key != KeyboardKey::q; });
  return presses;
}

void Window::begin_interface() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  // The backend counts in the system's units.
  ImGuiIO& io = ImGui::GetIO();
  const float scale = impl_->content_scale;
  io.DisplaySize = {io.DisplaySize.x / scale, io.DisplaySize.y / scale};
  io.DisplayFramebufferScale = {io.DisplayFramebufferScale.x * scale, io.DisplayFramebufferScale.y * scale};
  if (ImGui::IsMousePosValid(&io.MousePos)) io.MousePos = {io.MousePos.x / scale, io.MousePos.y / scale};
  ImGui::NewFrame();
}

Result<void> Window::show(const Renderer& renderer, int left, int top, std::span<const DockedPanel> docked) {
  return vulkan_call("showing the picture", [&] {
    ImGui::Render();
    const PictureSize size = this->size();
    if (size.width == 0 || size.height == 0) return;
    impl_->swapchain->resize(size.width, size.height);
    WindowContent content;
    const Target& picture = picture_target(renderer);
    content.picture = *picture_image(renderer).image;
    content.format = picture.colour_format;
    content.size = vk::Extent2D(picture.width, picture.height);
    content.at = vk::Offset2D(left, top);
    // Panels are kept pixel by pixel, which their units must be.
    if (pixels_per_unit() != 1.0) docked = {};
    impl_->panels.take(*ImGui::GetDrawData(), docked, size.width, size.height, impl_->swapchain->generation(), content);
    impl_->swapchain->show(content);
  });
}

}  // namespace sinew
