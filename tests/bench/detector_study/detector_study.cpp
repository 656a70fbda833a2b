// SPDX-License-Identifier: MIT
// How good a detector is on pictures of real water (docs/detectors.md):
//   detector_study BUOYS GATES [NAME [KEY=VALUE]...]
// BUOYS: a folder of frames with labels.csv; GATES: a folder of images without a ball; NAME: the
// detector, its parameters after it. Prints a row per kind of picture, at pNav's threshold.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/core/random.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "tests/bench/detector_study/degradations.hpp"
#include "tests/support/labelled_frames.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr double kThreshold = 0.45;  ///< pNav's min_confidence

struct Frame {
  cv::Mat picture;
  std::vector<FrameLabel> labels;
};

ImageView ViewOf(const cv::Mat& picture) {
  return {picture.ptr<std::uint8_t>(), picture.cols, picture.rows};
}

std::vector<Frame> ReadBuoys(const fs::path& folder) {
  std::vector<Frame> frames;
  for (const auto& [name, labels] : ReadFrameLabels(folder / "labels.csv"))
    frames.push_back({cv::imread((folder / name).string()), labels});
  return frames;
}

std::vector<cv::Mat> ReadPictures(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<cv::Mat> pictures;
  for (const fs::path& file : files) {
    cv::Mat picture = cv::imread(file.string());
    if (!picture.empty()) pictures.push_back(picture);
  }
  return pictures;
}

/// Gate pictures 640 wide with real balls, cut out along their circles, in two places.
std::vector<Frame> PasteBalls(const std::vector<Frame>& buoys, const std::vector<cv::Mat>& gates) {
  struct Cutting {
    cv::Mat picture;
    FrameLabel label;
  };
  std::vector<Cutting> balls;
  for (const Frame& frame : buoys) {
    for (const FrameLabel& label : frame.labels) {
      const cv::Rect rect(cvFloor(label.rect.left), cvFloor(label.rect.top),
                          cvRound(label.rect.width()), cvRound(label.rect.height()));
      const bool is_whole = (rect & cv::Rect({}, frame.picture.size())) == rect;
      if (label.visible_fraction > 0.97 && is_whole) balls.push_back({frame.picture(rect), label});
    }
  }
  Random random(5, "pasted balls");
  std::vector<Frame> made;
  for (const cv::Mat& gate : gates) {
    Frame frame;
    cv::resize(gate, frame.picture, {640, 640 * gate.rows / gate.cols}, 0.0, 0.0, cv::INTER_AREA);
    for (int half = 0; half < 2; ++half) {
      const Cutting& ball = balls[random.Index(balls.size())];
      const cv::Size size = ball.picture.size();
      const auto draw = [&](int count) {
        return static_cast<int>(random.Index(static_cast<std::uint64_t>(count)));
      };
      const int row = draw(frame.picture.rows - size.height), column = draw(320 - size.width);
      const cv::Point at(320 * half + column, row);
      cv::Mat mask(size, CV_8U, cv::Scalar(0));
      cv::circle(mask, {size.width / 2, size.height / 2}, cvFloor(ball.label.radius) - 1,
                 cv::Scalar(255), cv::FILLED);
      ball.picture.copyTo(frame.picture(cv::Rect(at, size)), mask);
      FrameLabel label = ball.label;
      label.rect = {static_cast<double>(at.x), static_cast<double>(at.y),
                    static_cast<double>(at.x + size.width),
                    static_cast<double>(at.y + size.height)};
      frame.labels.push_back(label);
    }
    made.push_back(frame);
  }
  return made;
}

/// Expected calibration error in ten bins, over boxes that are right or wrong.
class Calibration {
 public:
  void Add(double confidence, bool is_right) {
    Bin& bin = bins_.at(static_cast<std::size_t>(std::clamp(10.0 * confidence, 0.0, 9.0)));
    ++bin.count;
    bin.stated += confidence;
    bin.right += is_right ? 1 : 0;
  }
  [[nodiscard]] double Error() const {
    double sum = 0.0;
    int count = 0;
    for (const Bin& bin : bins_) {
      sum += std::abs(bin.stated - bin.right);
      count += bin.count;
    }
    return count > 0 ? sum / count : 0.0;
  }

 private:
  struct Bin {
    int count = 0, right = 0;
    double stated = 0.0;
  };
  std::array<Bin, 10> bins_{};
};

class Study {
 public:
  explicit Study(std::unique_ptr<Detector> detector) : detector_(std::move(detector)) {}

  DetectionTally Tally(const Frame& frame, Calibration& calibration) {
    std::vector<Box> boxes = detector_->Detect(ViewOf(frame.picture));
    std::vector<int> right;
    static_cast<void>(TallyBoxes(boxes, frame.labels, &right));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (right[i] != 2) calibration.Add(boxes[i].confidence, right[i] == 1);
    }
    std::erase_if(boxes, [](const Box& box) { return box.confidence < kThreshold; });
    return TallyBoxes(boxes, frame.labels);
  }
  void PrintRow(const std::string& name, const std::vector<Frame>& frames) {
    Calibration calibration;
    DetectionTally all;
    for (const Frame& frame : frames)
      all.Add(Tally(frame, calibration));
    fmt::print("| {} | {} | {:.3f} / {:.3f} | {:.3f} / {:.3f} | {:.2f} | {:.3f} |\n", name,
               frames.size(), all.recall(), all.precision(), all.class_recall(),
               all.class_precision(),
               static_cast<double>(all.invented) / static_cast<double>(frames.size()),
               calibration.Error());
  }
  void PrintColor(const std::string& color, const std::vector<Frame>& frames) {
    DetectionTally all;
    for (const Frame& frame : frames) {
      std::vector<Box> boxes = detector_->Detect(ViewOf(frame.picture));
      std::erase_if(
          boxes, [&](const Box& box) { return box.confidence < kThreshold || box.color != color; });
      std::vector<FrameLabel> labels = frame.labels;
      std::erase_if(labels, [&](const FrameLabel& label) { return label.color != color; });
      all.Add(TallyBoxes(boxes, labels));
    }
    fmt::print("| {} | {} | {:.3f} / {:.3f} | | {:.2f} | |\n", color, frames.size(), all.recall(),
               all.precision(),
               static_cast<double>(all.invented) / static_cast<double>(frames.size()));
  }
  /// Processor time of one picture [ms].
  double Cost(const std::vector<Frame>& frames) {
    const auto start = std::clock();
    for (int round = 0; round < 3; ++round) {
      for (const Frame& frame : frames)
        static_cast<void>(detector_->Detect(ViewOf(frame.picture)));
    }
    return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / 3.0 /
           static_cast<double>(frames.size());
  }

 private:
  std::unique_ptr<Detector> detector_;
};

std::unique_ptr<Detector> MakeFrom(int argc, char** argv) {
  const std::string name = argc > 3 ? argv[3] : "color_shape";
  auto factory = FindDetector(name);
  if (!factory) throw std::runtime_error(factory.error().text);
  ConfigBlock block{.name = name, .where = {}, .entries = {}};
  for (int i = 4; i < argc; ++i) {
    const std::string text = argv[i];
    const std::size_t equals = std::min(text.find('='), text.size() - 1);
    block.entries.push_back(
        {.key = text.substr(0, equals), .value = text.substr(equals + 1), .where = {}});
  }
  const auto problems = ApplyBlock(block, (*factory)->Parameters());
  if (!problems.empty()) throw std::runtime_error(problems.front().Format());
  return (*factory)->Make();
}

void Run(int argc, char** argv) {
  const std::vector<Frame> buoys = ReadBuoys(argv[1]);
  const std::vector<cv::Mat> gates = ReadPictures(argv[2]);
  Study study(MakeFrom(argc, argv));
  fmt::print(
      "| pictures | n | any class: recall / precision | right class | invented per picture | ECE "
      "|\n| --- | --- | --- | --- | --- | --- |\n");
  for (const char* color : {"yellow", "orange", "green"})
    study.PrintColor(color, buoys);
  for (const Degradation& worse : Degradations()) {
    std::vector<Frame> frames;
    for (const Frame& frame : buoys)
      frames.push_back({worse.apply(frame.picture), frame.labels});
    study.PrintRow(worse.name, frames);
  }
  std::vector<Frame> negatives;
  for (const cv::Mat& gate : gates)
    negatives.push_back({gate, {}});
  study.PrintRow("gates, no ball", negatives);
  study.PrintRow("balls pasted on gates", PasteBalls(buoys, gates));
  fmt::print("{:.1f} ms per picture\n", study.Cost(buoys));
}

}  // namespace
}  // namespace limpet

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: detector_study BUOYS GATES [NAME [KEY=VALUE]...]\n");
    return 2;
  }
  try {
    limpet::Run(argc, argv);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "detector_study: {}\n", problem.what());
    return 1;
  }
  return 0;
}
