#pragma once
/// A device for tests, opened once a test program with the validation layer on.

#include <cstdlib>

#include <gtest/gtest.h>

#include "engine/gpu/device.h"

namespace sinew::test {

/// Ends the program's tests where no device can be had: they prove nothing without one.
inline Device& device() {
  static Result<Device> opened = [] {
    const char* wanted = std::getenv("SINEW_DEVICE");
    return Device::create({wanted != nullptr ? wanted : "", true});
  }();
  if (!opened) {
    ADD_FAILURE() << opened.error().message;
    std::abort();
  }
  return *opened;
}

/// Fails a test during which the validation layer said something.
class DeviceTest : public ::testing::Test {
 protected:
  void SetUp() override { messages_before_ = device().validation_messages().size(); }
  void TearDown() override {
    const auto messages = device().validation_messages();
    for (std::size_t i = messages_before_; i < messages.size(); ++i) ADD_FAILURE() << messages[i];
  }

 private:
  std::size_t messages_before_ = 0;
};

}  // namespace sinew::test
