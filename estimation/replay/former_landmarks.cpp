// SPDX-License-Identifier: MIT
#include "estimation/replay/former_landmarks.hpp"

#include <array>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "estimation/replay/csv_fields.hpp"
#include "limpet/core/lower_triangle.hpp"

namespace limpet {
namespace {

constexpr const char* kLandmarks = "landmarks.csv";
constexpr const char* kCovariance = "landmarks_covariance.csv";
constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

/// Calls `read` for every line but the header.
std::optional<Error> ReadRows(const StreamFile& file,
                              const std::function<void(const CsvFields&)>& read) {
  for (std::size_t i = 1; i < file.lines.size(); ++i) {
    try {
      read(CsvFields(file.lines[i]));
    } catch (const BadLine& bad) {
      return Error{fmt::format("{}:{}: {}", file.name, i + 1, bad.why)};
    }
  }
  return std::nullopt;
}

}  // namespace

std::string LandmarksCsv(const std::vector<Landmark>& landmarks) {
  std::string text = "id,x,y,z,sd_x,sd_y,sd_z,class,looks\n";
  for (const Landmark& landmark : landmarks) {
    const Eigen::Vector3d sd = landmark.object.sd_W();
    text += fmt::format("{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},{}\n", landmark.id,
                        landmark.object.p_W.x(), landmark.object.p_W.y(), landmark.object.p_W.z(),
                        sd.x(), sd.y(), sd.z(), landmark.object.color, landmark.detections);
  }
  return text;
}

std::string LandmarkCovarianceCsv(const std::vector<Landmark>& landmarks,
                                  const Eigen::MatrixXd& covariance) {
  std::string text = "id,axis,covariance up to the diagonal\n";
  for (Eigen::Index row = 0; row < covariance.rows(); ++row) {
    text += fmt::format("{},{}", landmarks[static_cast<std::size_t>(row / 3)].id,
                        kAxes[static_cast<std::size_t>(row % 3)]);
    for (Eigen::Index column = 0; column <= row; ++column)
      text += fmt::format(",{:.9g}", covariance(row, column));
    text += '\n';
  }
  return text;
}

Expected<FormerSession> ParseFormerLandmarks(const StreamFile& landmarks,
                                             const StreamFile& covariance) {
  FormerSession former;
  const auto place = [&former](const CsvFields& f) {
    f.Expect(9);
    FormerObject& known = former.objects.emplace_back();
    known.id = f.Integer(0);
    ObjectEstimate& object = known.object;
    object.p_W = {f.Number(1), f.Number(2), f.Number(3)};
    object.cov_W = Eigen::Vector3d(f.Number(4), f.Number(5), f.Number(6)).cwiseAbs2().asDiagonal();
    object.color = f.Text(7);
    if (!object.p_W.allFinite() || !object.cov_W.allFinite()) throw BadLine{"not finite"};
  };
  if (auto error = ReadRows(landmarks, place)) return *std::move(error);
  std::vector<double> lower;
  std::size_t rows = 0;
  const auto correlate = [&](const CsvFields& f) {
    const std::size_t at = rows / 3;
    if (at >= former.objects.size() || f.Integer(0) != former.objects[at].id) {
      throw BadLine{fmt::format("not the next landmark of {}", landmarks.name)};
    }
    f.Expect(++rows + 2);
    for (std::size_t i = 2; i < f.size(); ++i)
      lower.push_back(f.Number(i));
  };
  if (auto error = ReadRows(covariance, correlate)) return *std::move(error);
  const auto joint = FromLowerTriangle(lower);
  if (!joint || rows != 3 * former.objects.size()) {
    return Error{fmt::format("{}: not three finite rows for each of {} landmarks", covariance.name,
                             former.objects.size())};
  }
  former.joint_cov_W = *joint;
  return former;
}

Expected<FormerSession> LoadFormerLandmarks(const std::filesystem::path& folder) {
  std::array<StreamFile, 2> files;
  for (std::size_t i = 0; i < files.size(); ++i) {
    Expected<StreamFile> file = ReadLines(folder / (i == 0 ? kLandmarks : kCovariance));
    if (!file) return file.error();
    if (file->damage) return Error{*file->damage};
    files[i] = *std::move(file);
  }
  return ParseFormerLandmarks(files[0], files[1]);
}

}  // namespace limpet
