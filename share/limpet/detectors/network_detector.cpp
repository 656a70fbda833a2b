// SPDX-License-Identifier: MIT
#include "limpet/detectors/network_detector.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

#include "limpet/core/config.hpp"
#include "limpet/core/logistic.hpp"
#include "limpet/objects/pixel_rect.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/image_mat.hpp"

namespace limpet {
namespace {

constexpr double kLeastLogit = -2.2;     // of what is looked at at all: a score of 0.1
constexpr double kMostOverlap = 0.45;    // of boxes of two objects
constexpr int kInputStep = 16;           // what the network halves four times
constexpr double kLeastAgreement = 0.6;  // overlap of an outline's box with the network's

/// A ball whose visible part has this box: of one that the border cuts, the longer side is whole.
Ellipse GuessOf(const Box& box, const ImageView& image) {
  const Eigen::Vector2d half(0.5 * box.w, 0.5 * box.h);
  const double longer = half.maxCoeff();
  Ellipse guess{{box.u, box.v}, half.asDiagonal()};
  const auto stretch = [&](int axis, const BoxExtent& extent) {
    if (half[axis] >= longer || !extent.is_half_cut()) return;
    guess.center[axis] = extent.CentreOf(longer);
    guess.axes(axis, axis) = longer;
  };
  stretch(0, ExtentAcross(box, image.width_px));
  stretch(1, ExtentAlong(box, image.height_px));
  return guess;
}

}  // namespace

struct NetworkDetector::Net {
  cv::dnn::Net net;
  cv::Mat input, cells;

  Net(const NetworkDescription& description, const std::string& file) {
    try {
      net = cv::dnn::readNetFromONNX(description.weights.string());
      const cv::Mat black(2 * kInputStep, 2 * kInputStep, CV_8UC3, cv::Scalar());
      Forward(black);
    } catch (const cv::Exception& problem) {
      Fail(file, fmt::format("`{}` is no network that OpenCV can run: {}",
                             description.weights.string(), problem.err));
    }
    const auto channels = static_cast<int>(description.colors.size()) + 5;
    const int cells_across = 2 * kInputStep / description.stride_px;
    if (cells.dims != 4 || cells.size[1] != channels || cells.size[3] != cells_across) {
      Fail(file, fmt::format("`{}` does not give 5 channels and one per colour ({}) for every {} "
                             "pixels",
                             description.weights.string(), description.colors.size(),
                             description.stride_px));
    }
  }
  void Forward(const cv::Mat& image) {
    constexpr double kScale = 1.0 / 128.0;
    cv::dnn::blobFromImage(image, input, kScale, {}, cv::Scalar::all(128.0));
    net.setInput(input);
    net.forward(cells);
  }
  [[noreturn]] static void Fail(const std::string& file, const std::string& text) {
    throw ConfigError(ConfigProblem{.where = {file, 0}, .key = "weights", .text = text});
  }
};

NetworkDetector::NetworkDetector(const Params& params) : params_(params) {
  // As for every detector: one image is one thread's work.
  cv::setNumThreads(0);
  const std::filesystem::path file = FindNetwork(params.network);
  description_ = NetworkDescription::Read(file);
  net_ = std::make_unique<Net>(description_, file.string());
}

NetworkDetector::~NetworkDetector() = default;

cv::Size NetworkDetector::InputSize(const ImageView& image) const {
  const double pixels = static_cast<double>(image.width_px) * image.height_px;
  const double scale = std::sqrt(description_.input_pixels / pixels) / kInputStep;
  const auto steps = [scale](int side) {
    return kInputStep * std::max(2, static_cast<int>(std::lround(scale * side)));
  };
  return {steps(image.width_px), steps(image.height_px)};
}

double NetworkDetector::ConfidenceOf(const NetworkProposal& proposal) const {
  const double logit = description_.confidence_offset +
                       description_.confidence_per_score * proposal.score_logit +
                       description_.confidence_per_color * proposal.color_logit +
                       description_.confidence_per_roundness * proposal.roundness;
  return Logistic(logit);
}

void NetworkDetector::FollowOutline(const ImageView& image, NetworkProposal& proposal) const {
  const std::optional<BallOutline> found = outlines_.Find(GuessOf(proposal.box, image));
  if (!found) return;
  const PixelRect rect = found->outline.ellipse.VisiblePart(image.width_px, image.height_px);
  if (Overlap(rect, RectOf(proposal.box)) < kLeastAgreement) return;
  proposal.roundness = found->Roundness(image);
  if (proposal.roundness > 0.0) SetRect(rect, proposal.box);
}

std::vector<NetworkProposal> NetworkDetector::Propose(const ImageView& image) {
  if (std::min(image.width_px, image.height_px) < kLeastImageSide) return {};
  const cv::Size size = InputSize(image);
  const bool shrinks = size.width < image.width_px;
  cv::resize(MatOf(image), reduced_, size, 0.0, 0.0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  net_->Forward(reduced_);
  outlines_.Take(image);
  const double across = static_cast<double>(image.width_px) / size.width;
  const double down = static_cast<double>(image.height_px) / size.height;
  const PixelRect whole{0.0, 0.0, static_cast<double>(image.width_px),
                        static_cast<double>(image.height_px)};
  std::vector<NetworkProposal> proposals;
  for (const NetworkFinding& one :
       ReadCells(net_->cells, description_, {kLeastLogit, kMostOverlap})) {
    const PixelRect rect = Intersection({across * one.rect.left, down * one.rect.top,
                                         across * one.rect.right, down * one.rect.bottom},
                                        whole);
    if (rect.area() <= 0.0) continue;
    NetworkProposal proposal{.box = {},
                             .score_logit = one.score_logit,
                             .color_logit = one.color_logit,
                             .roundness = 0.0};
    proposal.box.color = description_.colors[one.color];
    SetRect(rect, proposal.box);
    FollowOutline(image, proposal);
    proposals.push_back(std::move(proposal));
  }
  return proposals;
}

NetworkProposal NetworkDetector::Weigh(const ImageView& image, const Box& box) const {
  const double across = static_cast<double>(reduced_.cols) / image.width_px;
  const double down = static_cast<double>(reduced_.rows) / image.height_px;
  const PixelRect rect = RectOf(box);
  const NetworkFinding finding =
      StrongestAt(net_->cells, description_,
                  {across * rect.left, down * rect.top, across * rect.right, down * rect.bottom});
  NetworkProposal proposal{.box = box,
                           .score_logit = finding.score_logit,
                           .color_logit = finding.color_logit,
                           .roundness = 0.0};
  FollowOutline(image, proposal);
  proposal.box = box;
  if (description_.colors[finding.color] != box.color) {
    proposal.color_logit = -proposal.color_logit;  // against the colour that the box has
  }
  return proposal;
}

std::vector<Box> NetworkDetector::Detect(const ImageView& image) {
  std::vector<Box> boxes;
  for (NetworkProposal& proposal : Propose(image)) {
    proposal.box.confidence = ConfidenceOf(proposal);
    if (proposal.box.confidence >= params_.least_confidence)
      boxes.push_back(std::move(proposal.box));
  }
  std::ranges::stable_sort(boxes, std::ranges::greater(), &Box::confidence);
  return boxes;
}

LIMPET_REGISTER_DETECTOR(NetworkDetector, "network");

}  // namespace limpet
