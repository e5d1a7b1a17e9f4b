#include "engine/view/window.h"

#include <cstring>

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

#include "engine/gpu/vulkan.h"
#include "engine/render/renderer_image.h"
#include "engine/view/kept_panels.h"
#include "engine/view/swapchain.h"

namespace sinew {
namespace {

constexpr float font_size = 15.0f;
/// Parts of the interface that are drawn by themselves in one frame: their buffers are used in turn.
constexpr std::uint32_t most_interface_draws = 16;

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason was given";
}

std::optional<KeyboardKey> key_of(int code, bool shift) {
  switch (code) {
    case GLFW_KEY_F:
      return KeyboardKey::f;
    case GLFW_KEY_K:
      return KeyboardKey::k;
    case GLFW_KEY_M:
      return KeyboardKey::m;
    case GLFW_KEY_P:
      return KeyboardKey::p;
    case GLFW_KEY_Q:
      return KeyboardKey::q;
    case GLFW_KEY_R:
      return KeyboardKey::r;
    case GLFW_KEY_S:
      return KeyboardKey::s;
    case GLFW_KEY_Y:
      return KeyboardKey::y;
    case GLFW_KEY_Z:
      return KeyboardKey::z;
    case GLFW_KEY_1:
    case GLFW_KEY_KP_1:
      return KeyboardKey::one;
    case GLFW_KEY_3:
    case GLFW_KEY_KP_3:
      return KeyboardKey::three;
    case GLFW_KEY_5:
    case GLFW_KEY_KP_5:
      return KeyboardKey::five;
    case GLFW_KEY_7:
    case GLFW_KEY_KP_7:
      return KeyboardKey::seven;
    case GLFW_KEY_9:
    case GLFW_KEY_KP_9:
      return KeyboardKey::nine;
    case GLFW_KEY_SPACE:
      return KeyboardKey::space;
    case GLFW_KEY_TAB:
      return KeyboardKey::tab;
    case GLFW_KEY_LEFT:
      return KeyboardKey::left;
    case GLFW_KEY_RIGHT:
      return KeyboardKey::right;
    case GLFW_KEY_HOME:
      return KeyboardKey::home;
    case GLFW_KEY_END:
      return KeyboardKey::end;
    case GLFW_KEY_F1:
      return KeyboardKey::help;
    case GLFW_KEY_SLASH:
      return shift ? std::optional(KeyboardKey::help) : std::nullopt;
    default:
      return std::nullopt;
  }
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
  float across = 1.0f, down = 1.0f;
  glfwGetWindowContentScale(window, &across, &down);
  if (!options.font.empty()) io.Fonts->AddFontFromFileTTF(options.font.c_str(), font_size * across);
  ImGui::GetStyle().ScaleAllSizes(across);
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
  impl->window = glfwCreateWindow(options.size.width, options.size.height, options.title.c_str(), nullptr, nullptr);
  if (!impl->window)
    return failure(ErrorKind::no_device, "no window can be opened ({}); sinew render needs none", last_glfw_error());
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
    const auto key = key_of(code, shift);
    if (!key || action == GLFW_RELEASE) return;
    static_cast<Impl*>(glfwGetWindowUserPointer(window))
        ->presses.push_back({*key, (modifiers & GLFW_MOD_CONTROL) != 0, shift, action == GLFW_REPEAT});
  });
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
void Window::set_title(const std::string& title) { glfwSetWindowTitle(impl_->window, title.c_str()); }
void Window::set_clipboard(const std::string& text) { glfwSetClipboardString(impl_->window, text.c_str()); }

PictureSize Window::size() const {
  PictureSize size{0, 0};
  glfwGetFramebufferSize(impl_->window, &size.width, &size.height);
  return size;
}

bool Window::has_finer_pixels() const {
  int width = 0, height = 0;
  glfwGetWindowSize(impl_->window, &width, &height);
  const PictureSize pixels = size();
  return width != pixels.width || height != pixels.height;
}

double Window::scale() const {
  float across = 1.0f, down = 1.0f;
  glfwGetWindowContentScale(impl_->window, &across, &down);
  return across;
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
  return presses;
}

void Window::begin_interface() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

Result<void> Window::show(const Renderer& renderer, std::span<const DockedPanel> docked) {
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
    impl_->panels.take(*ImGui::GetDrawData(), docked, size.width, size.height, impl_->swapchain->generation(), content);
    impl_->swapchain->show(content);
  });
}

}  // namespace sinew
