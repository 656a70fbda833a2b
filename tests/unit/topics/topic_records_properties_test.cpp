// SPDX-License-Identifier: MIT
// Every topic that travels as `key=value` text, filled with random values: nothing is lost, order
// does not matter, and a record that lacks a field or holds a wrong one is none.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "limpet/core/random.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/sharing.hpp"
#include "limpet/topics/simulation.hpp"

namespace limpet {
namespace {

using FieldValue = std::variant<double, int, bool, std::string, std::optional<double>,
                                std::optional<bool>, std::optional<std::string>>;
struct NamedField {
  std::string name;
  FieldValue value;
  bool operator==(const NamedField&) const = default;
};

/// Reads the fields of a record, or fills them.
struct FieldCollector {
  std::vector<NamedField> fields;
  template <class T>
  void operator()(const char* name, const T& field) {
    fields.push_back({name, field});
  }
  template <class D>
  void operator()(const char* name, const Quantity<D>& field) {
    fields.push_back({name, field.in_text_unit()});
  }
  template <class T>
  void operator()(const char* name, const T& field, const char*, const auto&...) {
    (*this)(name, field);
  }
};

class FieldFiller {
 public:
  explicit FieldFiller(Random& random) : random_(random) {}
  void operator()(const char*, double& field) { field = Number(); }
  template <class D>
  void operator()(const char*, Quantity<D>& field) {
    field = Quantity<D>::FromTextUnit(Number());
  }
  template <class T>
  void operator()(const char* name, T& field, const char*, const auto&...) {
    (*this)(name, field);
  }
  void operator()(const char*, int& field) {
    field = static_cast<int>(random_.Index(2'000'000)) - 1'000'000;
  }
  void operator()(const char*, bool& field) { field = random_.Chance(0.5); }
  void operator()(const char*, std::string& field) {
    field = random_.Chance(0.5) ? "some words" : "x";
  }
  void operator()(const char*, std::optional<double>& field) {
    field = random_.Chance(0.7) ? std::optional(Number()) : std::nullopt;
  }
  void operator()(const char*, std::optional<bool>& field) {
    field = random_.Chance(0.7) ? std::optional(random_.Chance(0.5)) : std::nullopt;
  }
  void operator()(const char*, std::optional<std::string>& field) {
    // Within braces commas and signs of equality are text.
    const char* words = random_.Chance(0.5) ? "{1,2:3,4}" : "pts={1,2:3,4}{a=b,{c,d}}";
    field = random_.Chance(0.7) ? std::optional<std::string>(words) : std::nullopt;
  }

 private:
  /// Of every size that a double has, and with every digit.
  double Number() {
    const double size = std::exp(random_.Uniform(-300.0, 300.0));
    return random_.Chance(0.1) ? 0.0 : random_.Uniform(-1.0, 1.0) * size;
  }
  Random& random_;
};

template <class T>
class RecordProperty : public ::testing::Test {
 protected:
  T Next() {
    T record;
    FieldFiller fill(random_);
    record.Describe(fill);
    return record;
  }
  static std::vector<NamedField> FieldsOf(T record) {
    FieldCollector collect;
    record.Describe(collect);
    return collect.fields;
  }
  static std::string TextOf(const T& record) {
    return std::get<std::string>(TopicCodec<T>::Encode(record));
  }
  /// Apart at commas that no brace holds.
  static std::vector<std::string> PartsOf(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char letter : text) {
      depth += letter == '{' ? 1 : (letter == '}' ? -1 : 0);
      if (letter == ',' && depth == 0) {
        parts.emplace_back();
      } else {
        parts.back() += letter;
      }
    }
    return parts;
  }
  /// Any value is one of a text.
  static bool IsText(const T& record, const std::string& name) {
    return std::ranges::any_of(FieldsOf(record), [&name](const NamedField& field) {
      return field.name == name && std::holds_alternative<std::optional<std::string>>(field.value);
    });
  }
  static std::string Joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts)
      text += (text.empty() ? "" : ",") + part;
    return text;
  }
  static bool IsOptional(const T& record, const std::string& name) {
    for (const NamedField& field : FieldsOf(record)) {
      if (field.name == name) return field.value.index() >= 4;
    }
    ADD_FAILURE() << name;
    return false;
  }
  Random random_{17, "records"};
};

using Records = ::testing::Types<SurveyArea, HomePoint, ThrusterCommand, NavState, DeadReckoning,
                                 PosedBeams, ImuSample, DvlSample, GpsFix, Coverage, MapLook,
                                 SimTruth, SimThrust, ShareCounts, WaterCurrent>;
TYPED_TEST_SUITE(RecordProperty, Records);

TYPED_TEST(RecordProperty, BringsBackEveryFieldToTheLastBit) {
  for (int run = 0; run < 60; ++run) {
    const TypeParam sent = this->Next();
    const auto back = TopicCodec<TypeParam>::Decode(this->TextOf(sent));
    ASSERT_TRUE(back) << this->TextOf(sent);
    EXPECT_EQ(this->FieldsOf(*back), this->FieldsOf(sent)) << this->TextOf(sent);
  }
}

TYPED_TEST(RecordProperty, HasItsFieldsUnderNamesOfTheirOwn) {
  std::vector<std::string> names;
  for (const NamedField& field : this->FieldsOf(TypeParam{}))
    names.push_back(field.name);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end()) << "a name stands for two fields";
}

TYPED_TEST(RecordProperty, IsReadInAnyOrderAmongKeysOfNewerVersions) {
  for (int run = 0; run < 20; ++run) {
    const TypeParam sent = this->Next();
    std::vector<std::string> parts = this->PartsOf(this->TextOf(sent));
    parts.emplace_back("of_a_newer_version=7");
    std::ranges::shuffle(parts, this->random_.engine());
    const auto back = TopicCodec<TypeParam>::Decode(this->Joined(parts));
    ASSERT_TRUE(back);
    EXPECT_EQ(this->FieldsOf(*back), this->FieldsOf(sent));
  }
}

TYPED_TEST(RecordProperty, IsNoneWithoutAFieldThatItNeeds) {
  const TypeParam sent = this->Next();
  const std::vector<std::string> parts = this->PartsOf(this->TextOf(sent));
  for (std::size_t lost = 0; lost < parts.size(); ++lost) {
    std::vector<std::string> rest = parts;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(lost));
    const std::string name = parts[lost].substr(0, parts[lost].find('='));
    EXPECT_EQ(TopicCodec<TypeParam>::Decode(this->Joined(rest)).has_value(),
              this->IsOptional(sent, name))
        << name;
  }
}

TYPED_TEST(RecordProperty, IsNoneWithAWrongValueInAnyField) {
  const TypeParam sent = this->Next();
  const std::vector<std::string> parts = this->PartsOf(this->TextOf(sent));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (this->IsText(sent, parts[i].substr(0, parts[i].find('=')))) continue;
    for (const char* wrong : {"nan", "inf", "1e999", "maybe", "1 2", ""}) {
      std::vector<std::string> spoilt = parts;
      spoilt[i] = parts[i].substr(0, parts[i].find('=') + 1) + wrong;
      EXPECT_FALSE(TopicCodec<TypeParam>::Decode(this->Joined(spoilt))) << spoilt[i];
    }
  }
}

TYPED_TEST(RecordProperty, IsNoneOfAnotherMoosType) {
  EXPECT_FALSE(TopicCodec<TypeParam>::Decode(Value(1.0)));
  EXPECT_FALSE(TopicCodec<TypeParam>::Decode(Value(Binary{})));
}

TEST(RecordProperty, RefusesAWholeNumberThatNoFieldHolds) {
  MapLook look;
  look.width_px = 640;
  const std::string text = std::get<std::string>(TopicCodec<MapLook>::Encode(look));
  for (const char* wrong : {"99999999999", "640.5", "-99999999999"}) {
    std::string spoilt = text;
    spoilt.replace(spoilt.find("=640") + 1, 3, wrong);
    EXPECT_FALSE(TopicCodec<MapLook>::Decode(spoilt)) << wrong;
  }
}

}  // namespace
}  // namespace limpet
