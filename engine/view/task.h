#pragma once
/// One long piece of work beside the window. No Vulkan here.

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <new>
#include <optional>
#include <string>

#include "engine/core/task_watch.h"

namespace sinew {

/// Work beside the window, whatever comes of it: what a list of all such work shows.
class WorkBeside {
 public:
  using Clock = std::chrono::steady_clock;

  virtual ~WorkBeside() = default;
  virtual bool running() const = 0;

  const std::string& what() const { return what_; }
  double share() const { return watch_ ? watch_->share() : 0.0; }
  /// Since it was started.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }
  void cancel() {
    if (watch_) watch_->cancel();
  }
  bool is_cancelled() const { return watch_ && watch_->is_cancelled(); }

 protected:
  WorkBeside() = default;
  WorkBeside(WorkBeside&&) noexcept = default;
  void begin(std::string what) {
    what_ = std::move(what);
    watch_ = std::make_unique<TaskWatch>();
    begun_ = Clock::now();
  }

  std::string what_;
  std::unique_ptr<TaskWatch> watch_;
  Clock::time_point begun_;
};

/// At most one at a time. To be used from one thread; whoever destroys it waits for the work to stop.
template <class T>
class Task : public WorkBeside {
 public:
  using Work = std::function<Result<T>(TaskWatch&)>;

  Task() = default;
  Task(Task&&) noexcept = default;
  Task& operator=(Task&&) = delete;
  ~Task() override {
    if (!running()) return;
    cancel();
    outcome_.wait();
  }

  /// `what`: for people, such as "fitting walk". Nothing happens where other work is still running.
  bool start(std::string what, Work work) {
    if (running()) return false;
    begin(std::move(what));
    outcome_ = std::async(std::launch::async, [work = std::move(work), watch = watch_.get()]() -> Result<T> {
      try {
        return work(*watch);
      } catch (const std::bad_alloc&) {
        return failure(ErrorKind::device_failed, "there is not enough memory for that");
      }
    });
    return true;
  }
  bool running() const override { return outcome_.valid(); }
  /// What came of it, once, when it is done.
  std::optional<Result<T>> take() {
    if (!running() || outcome_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
    return outcome_.get();
  }

 private:
  std::future<Result<T>> outcome_;
};

}  // namespace sinew
