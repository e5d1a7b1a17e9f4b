#include "engine/view/film_recorder.h"

namespace sinew {

Result<CaptureReport> record(const Recording& recording, TaskWatch& watch) {
  CaptureOptions options;
  options.scene = recording.options;
  options.look = recording.look;
  options.output = recording.output;
  options.progress = ProgressStyle::none;
  options.watch = &watch;
  if (auto ok = check_output(options); !ok) return pass_on(std::move(ok));
  Stage stage;
  stage.source = recording.source;
  if (auto ok = restage(stage, recording.scene, recording.options); !ok) return pass_on(std::move(ok));
  auto device = Device::create(recording.device);
  if (!device) return pass_on(std::move(device));
  auto report = capture(*device, stage, options);
  if (const auto messages = device->validation_messages(); report && !messages.empty())
    return failure(ErrorKind::check_failed, "{} messages from the validation layer, the first: {}", messages.size(),
                   messages.front());
  return report;
}

}  // namespace sinew
