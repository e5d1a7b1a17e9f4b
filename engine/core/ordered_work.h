#pragma once
/// Work on a stream of items beside the thread that makes them: several at a time, outcomes in the order of the items.

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace sinew {

/// Hands items to threads of its own. To be used from one thread. What the work throws, taking its outcome throws.
template <class Item, class Outcome>
class OrderedWork {
 public:
  using Work = std::function<Outcome(Item)>;

  /// `places`: how many items may be waiting or worked on, so that a slow work holds its maker up instead of filling
  /// the memory.
  OrderedWork(std::size_t threads, std::size_t places, Work work) : places_(places), work_(std::move(work)) {
    for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
  }

  /// Finishes what was added.
  ~OrderedWork() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    changed_.notify_all();
  }

  OrderedWork(const OrderedWork&) = delete;
  OrderedWork& operator=(const OrderedWork&) = delete;

  /// Waits for a place.
  void add(Item item) {
    Task task([this, item = std::move(item)]() mutable { return work_(std::move(item)); });
    outcomes_.push_back(task.get_future());
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return unfinished_ < places_; });
    ++unfinished_;
    tasks_.push_back(std::move(task));
    lock.unlock();
    changed_.notify_all();
  }

  /// The outcome of the first item whose outcome was not taken yet, if it is there.
  std::optional<Outcome> take_ready() {
    if (outcomes_.empty() || outcomes_.front().wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      return std::nullopt;
    return take();
  }

  /// The same, waited for; nothing where no item is left.
  std::optional<Outcome> take_next() {
    if (outcomes_.empty()) return std::nullopt;
    return take();
  }

 private:
  using Task = std::packaged_task<Outcome()>;

  Outcome take() {
    std::future<Outcome> first = std::move(outcomes_.front());
    outcomes_.pop_front();
    return first.get();
  }

  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return closed_ || !tasks_.empty(); });
      if (tasks_.empty()) return;
      {
        Task task = std::move(tasks_.front());
        tasks_.pop_front();
        lock.unlock();
        task();
      }
      lock.lock();
      --unfinished_;
      changed_.notify_all();
    }
  }

  const std::size_t places_;
  const Work work_;
  std::deque<std::future<Outcome>> outcomes_;  ///< in the order of the items; the maker's thread alone touches it

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> tasks_;      ///< that wait
  std::size_t unfinished_ = 0;  ///< waiting or worked on
  bool closed_ = false;
  std::vector<std::jthread> threads_;  ///< last: they end before what they use does
};

}  // namespace sinew
