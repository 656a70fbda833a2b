// SPDX-License-Identifier: MIT
// What a scenario may say of how its pictures come about. The models are in share/limpet/imaging.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "limpet/core/key_section.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// What may cover the seabed of a picture.
inline constexpr std::array kSeabedKinds{"sand", "gravel", "rock", "seagrass", "mixed"};

struct ImageParams {
  std::string look = "plain";

  template <class V>
  void Describe(V& visit) {
    visit.Choice("look", look,
                 "plain: clean pictures, nothing of the sections below; real: all of them",
                 {"plain", "real"});
  }

  /// Besides `water.visibility_m`, which sets how much of everything there is.
  struct Water {
    double dissolved = 0.5;
    double backscatter = 1.0;
    double forward_scatter = 0.25;
    double particles = 60.0;

    template <class V>
    void Describe(V& visit) {
      visit("dissolved", dissolved,
            "Absorption by dissolved matter at 440 nm over scattering; 0: blue water, 0.5: green, "
            "2: brown",
            InRange(0.0, 5.0));
      visit("backscatter", backscatter,
            "Light that the water itself sends into the lens, over that of single scattering by "
            "coastal particles",
            InRange(0.0, 5.0));
      visit("forward_scatter", forward_scatter,
            "Share of the scattered light that arrives beside its place, as a glow",
            InRange(0.0, 1.0));
      visit("particles", particles, "Drifting flakes in one picture, mean", InRange(0.0, 2000.0));
    }
  } water;

  struct Light {
    double sun = 1.0;
    Radians elevation = Radians::FromTextUnit(55.0);
    Radians azimuth = Radians::FromTextUnit(215.0);
    double caustics = 0.5;
    double lamp = 0.0;
    double lamp_off = 0.25;
    Radians lamp_beam = Radians::FromTextUnit(45.0);

    template <class V>
    void Describe(V& visit) {
      using namespace literals;
      visit("sun", sun, "Sunlight just below the surface; 1: a clear noon, 0: night",
            InRange(0.0, 2.0));
      visit("sun_elevation_deg", elevation, "Of the sun, as seen under water",
            InRange(42.0_deg, 90.0_deg));
      visit("sun_azimuth_deg", azimuth, "The sun stands there, clockwise from north",
            InRange(-360.0_deg, 360.0_deg));
      visit("caustics", caustics,
            "Light gathered by waves: contrast 1 m below the surface; fades with depth",
            InRange(0.0, 2.0));
      visit("lamp", lamp,
            "Light of the vehicle's lamp 1 m before it, over that of the sun at the surface",
            InRange(0.0, 20.0));
      visit("lamp_off_m", lamp_off, "The lamp is so far aft of the camera", InRange(0.0, 3.0));
      visit("lamp_beam_deg", lamp_beam, "Off its axis the lamp is down to 61 % there",
            InRange(5.0_deg, 90.0_deg));
    }
  } light;

  struct Seabed {
    std::string kind = "mixed";
    double shading = 1.0;

    template <class V>
    void Describe(V& visit) {
      visit.Choice("kind", kind, "What covers it", {kSeabedKinds.begin(), kSeabedKinds.end()});
      visit("shading", shading, "Steepness of its small forms, over that of the kind",
            InRange(0.0, 3.0));
    }
  } seabed;

  struct Clutter {
    double natural_per_m2 = 0.3;
    double litter_per_m2 = 0.01;

    template <class V>
    void Describe(V& visit) {
      visit("natural_per_m2", natural_per_m2, "Stones, plants, starfish, shells on the seabed",
            InRange(0.0, 10.0));
      visit("litter_per_m2", litter_per_m2,
            "Cans, bags, planks and balls, some in a buoy's colours; on top of what "
            "sensors.false_detections_per_image asks for",
            InRange(0.0, 10.0));
    }
  } clutter;

  struct Lens {
    double blur = 0.7;
    double vignette = 0.35;

    template <class V>
    void Describe(V& visit) {
      visit("blur_px", blur, "1-sigma of a point's image", InRange(0.0, 5.0));
      visit("vignette", vignette, "Share of the light that the image's corners lack",
            InRange(0.0, 0.95));
    }
  } lens;

  struct Sensor {
    double exposure = 0.0;
    double white_balance = 0.6;
    double full_well = 6000.0;
    double read_noise = 8.0;
    double contrast = 0.35;
    double saturation = 1.15;
    double jpeg_quality = 85.0;

    template <class V>
    void Describe(V& visit) {
      visit("exposure_ev", exposure, "Stops over what the automatic exposure chooses",
            InRange(-4.0, 4.0));
      visit("white_balance", white_balance,
            "Share of the picture's cast that the automatic white balance takes away",
            InRange(0.0, 1.0));
      visit("full_well_e", full_well,
            "Electrons of a white pixel without gain; what shot noise comes from",
            InRange(100.0, 1e6));
      visit("read_noise_e", read_noise, "1-sigma of a dark pixel in electrons",
            InRange(0.0, 500.0));
      visit("contrast", contrast, "Of the tone curve, on top of gamma", InRange(0.0, 1.0));
      visit("saturation", saturation, "Of the colours, as the camera processes them",
            InRange(0.0, 3.0));
      visit("jpeg_quality", jpeg_quality, "Of the camera's stream; 0: not compressed",
            InRange(0.0, 100.0));
    }
  } sensor;
};

/// Sections of `image:` in scenario.yaml; "" is `image:` itself. The keys store into `image`.
[[nodiscard]] inline std::vector<KeySection> ImageSections(ImageParams& image) {
  return {{"", DescribeParams(image)},
          {"water", DescribeParams(image.water)},
          {"light", DescribeParams(image.light)},
          {"seabed", DescribeParams(image.seabed)},
          {"clutter", DescribeParams(image.clutter)},
          {"lens", DescribeParams(image.lens)},
          {"sensor", DescribeParams(image.sensor)}};
}

}  // namespace limpet
