#include "by_hand.h"

#include <coroutine>
#include <deque>
#include <exception>

#include "VfirW12STAGES3.h"

namespace by_hand {
namespace {

// A coroutine that runs until the simulation ends.
struct Task {
  struct promise_type {
    Task get_return_object() { return {std::coroutine_handle<promise_type>::from_promise(*this)}; }
    std::suspend_never initial_suspend() { return {}; }
    std::suspend_always final_suspend() noexcept { return {}; }
    void return_void() {}
    void unhandled_exception() { std::terminate(); }
  };
  std::coroutine_handle<promise_type> handle;
};

// Who waits for what.
struct Trigger {
  std::vector<std::coroutine_handle<>> waiting, woken;

  bool await_ready() const { return false; }
  void await_suspend(std::coroutine_handle<> who) { waiting.push_back(who); }
  void await_resume() const {}
  void fire() {
    woken.swap(waiting);
    for (const auto who : woken) who.resume();
    woken.clear();
  }
};

constexpr int width = 12;
constexpr int mask = (1 << width) - 1, result_mask = (1 << (width + 5)) - 1;

class Bench {
 public:
  Bench(VfirW12STAGES3& top, const Case& given) : top_(top), given_(given) {}

  std::size_t run() {
    top_.rst = 1;
    top_.x_valid = top_.y_ready = 0;
    for (int i = 0; i < 2; ++i) clock();
    top_.rst = 0;
    Task tasks[] = {drive_in(), drive_out(), watch_in(), watch_out()};
    constexpr int watchdog = 1000;
    for (int quiet = 0; right_ < given_.samples.size() && !wrong_ && quiet < watchdog;) {
      const std::size_t before = right_;
      top_.clk = 0;
      top_.eval();
      settled_.fire();
      top_.clk = 1;
      top_.eval();
      edge_.fire();
      quiet = right_ == before ? quiet + 1 : 0;
    }
    for (const Task& t : tasks) t.handle.destroy();
    return right_;
  }

 private:
  void clock() {
    top_.clk = 0;
    top_.eval();
    top_.clk = 1;
    top_.eval();
  }

  Task drive_in() {
    for (std::size_t n = 0; n < given_.samples.size(); ++n) {
      for (int i = 0; i < given_.stalls[n]; ++i) {
        top_.x_valid = 0;
        co_await edge_;
      }
      top_.x_valid = 1;
      top_.x_data = static_cast<std::uint16_t>(given_.samples[n] & mask);
      for (bool taken = false; !taken;) {
        co_await settled_;
        taken = top_.x_ready != 0;
        co_await edge_;
      }
    }
    top_.x_valid = 0;
  }
  Task drive_out() {
    for (std::size_t n = 0; n < given_.waits.size(); ++n) {
      bool seen = !given_.sees_valid[n];
      for (int i = 0; i < given_.waits[n] || !seen; ++i) {
        top_.y_ready = 0;
        co_await settled_;
        seen |= top_.y_valid != 0;
        co_await edge_;
      }
      top_.y_ready = 1;
      for (bool came = false; !came;) {
        co_await settled_;
        came = top_.y_valid != 0;
        co_await edge_;
      }
    }
  }
  Task watch_in() {
    int x[5] = {};
    for (;;) {
      co_await settled_;
      if (top_.x_valid == 0 || top_.x_ready == 0) continue;
      for (int i = 4; i > 0; --i) x[i] = x[i - 1];
      x[0] = (top_.x_data ^ (1 << (width - 1))) - (1 << (width - 1));
      expected_.push_back(9 * x[2] + 5 * (x[1] + x[3]) - (x[0] + x[4]));
    }
  }
  Task watch_out() {
    for (;;) {
      co_await settled_;
      if (top_.y_valid == 0 || top_.y_ready == 0) continue;
      wrong_ =
          expected_.empty() || static_cast<int>(top_.y_data) != (expected_.front() & result_mask);
      if (wrong_) co_return;
      expected_.pop_front();
      ++right_;
    }
  }

  VfirW12STAGES3& top_;
  const Case& given_;
  Trigger settled_, edge_;
  std::deque<int> expected_;
  std::size_t right_ = 0;
  bool wrong_ = false;
};

}  // namespace

std::size_t run(VfirW12STAGES3& top, const Case& given) { return Bench(top, given).run(); }

}  // namespace by_hand
