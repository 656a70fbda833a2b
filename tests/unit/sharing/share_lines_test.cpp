// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

std::vector<ShareOutput> Outputs(std::string_view line, const MulticastPlan& plan = {}) {
  const auto outputs = ParseShareOutputs(line, plan);
  EXPECT_TRUE(outputs.has_value()) << (outputs ? "" : outputs.error().text);
  return outputs ? *outputs : std::vector<ShareOutput>(1);
}
std::string OutputError(std::string_view line) {
  const auto outputs = ParseShareOutputs(line, {});
  return outputs ? "" : outputs.error().text;
}
ShareInput Input(std::string_view line) {
  const auto input = ParseShareInput(line, {});
  EXPECT_TRUE(input.has_value()) << (input ? "" : input.error().text);
  return input ? *input : ShareInput{};
}

TEST(ShareOutputLine, ReadsEveryWordThatMoosUsersWrite) {
  const auto outputs = Outputs(
      "src_name=X, dest_name=Y, route=localhost:9021 & multicast_7, frequency=2, duration=60, "
      "max_shares=3");
  ASSERT_THAT(outputs, SizeIs(2));
  EXPECT_EQ(outputs[0].source, "X");
  EXPECT_EQ(outputs[0].dest, "Y");
  EXPECT_EQ(outputs[0].address.Text(), "localhost:9021");
  EXPECT_EQ(outputs[1].address.Text(), "224.1.1.11:24467:multicast_7");
  EXPECT_EQ(outputs[1].max_hz, 2.0);
  EXPECT_EQ(outputs[1].duration, Seconds(60.0));
  EXPECT_EQ(outputs[1].max_shares, 3);
}

TEST(ShareOutputLine, KeepsTheNameUnlessAnotherIsGiven) {
  EXPECT_EQ(Outputs("src_name=X,route=a:1").front().dest, "X");
}

TEST(ShareOutputLine, ReadsTheShortForm) {
  const auto outputs = Outputs("X->Y:localhost:9021@2 & multicast_7, S2->S3:multicast_8, T->a:1");
  ASSERT_THAT(outputs, SizeIs(4));
  EXPECT_EQ(outputs[0].dest, "Y");
  EXPECT_EQ(outputs[0].max_hz, 2.0);
  EXPECT_EQ(outputs[1].dest, "X");
  EXPECT_EQ(outputs[1].address.channel, 7);
  EXPECT_EQ(outputs[2].dest, "S3");
  EXPECT_EQ(outputs[2].address.channel, 8);
  EXPECT_EQ(outputs[3].address.Text(), "a:1");
}

TEST(ShareOutputLine, ReadsPatternsOfVariablesAndApps) {
  const ShareOutput output = Outputs("src_name=NAV_*:pN?v, dest_name=V_, route=a:1").front();
  EXPECT_TRUE(output.is_pattern());
  EXPECT_EQ(output.source, "NAV_*");
  EXPECT_EQ(output.app_pattern, "pN?v");
  EXPECT_EQ(output.dest, "V_");
}

TEST(ShareOutputLine, PlacesChannelsWhereTheMissionSays) {
  const auto outputs = Outputs("X->multicast_3", {.group = "224.9.9.9", .base_port = 5000});
  EXPECT_EQ(outputs.front().address.Text(), "224.9.9.9:5003:multicast_3");
}

TEST(ShareOutputLine, ReadsKeyAndPlainInBothForms) {
  EXPECT_EQ(Outputs("src_name=X,route=a:1,key=keys/k").front().security.key_file, "keys/k");
  EXPECT_TRUE(Outputs("X->a:1, plain=true").front().security.is_plain);
}

TEST(ShareOutputLine, SaysWhatIsWrong) {
  EXPECT_THAT(OutputError("src_nam=X, route=a:1"), HasSubstr("did you mean `src_name`"));
  EXPECT_THAT(OutputError("src_name=X, route=a"), HasSubstr("host:port or multicast_N"));
  EXPECT_THAT(OutputError("src_name=X, route=a:99999"), HasSubstr("`a:99999` is no route"));
  EXPECT_THAT(OutputError("src_name=X, route=multicast_256"), HasSubstr("multicast_255"));
  EXPECT_THAT(OutputError("src_name=X, route=a:0"), HasSubstr("port 0"));
  EXPECT_THAT(OutputError("route=a:1"), HasSubstr("names no variable"));
  EXPECT_THAT(OutputError("src_name=X, src_name=Y, route=a:1"), HasSubstr("said twice"));
  EXPECT_THAT(OutputError("src_name=X, route=a:1, frequency=often"), HasSubstr("frequency"));
  EXPECT_THAT(OutputError("src_name=A*B*, dest_name=^, route=a:1"), HasSubstr("one *"));
  EXPECT_THAT(OutputError("src_name=X, route=a:1, key=k, plain=true"), HasSubstr("not both"));
  EXPECT_THAT(OutputError("X"), HasSubstr("neither"));
  EXPECT_THAT(OutputError(""), HasSubstr("neither"));
}

TEST(ShareInputLine, ReadsRoutesWhiteListAndInterface) {
  const ShareInput input =
      Input("route = localhost:9021 & multicast_7, white_list = A* & B?, interface=127.0.0.1");
  ASSERT_THAT(input.addresses, SizeIs(2));
  EXPECT_EQ(input.addresses[1].channel, 7);
  EXPECT_THAT(input.white_list, ElementsAre("A*", "B?"));
  EXPECT_EQ(input.interface, "127.0.0.1");
}

TEST(ShareInputLine, ReadsTheShortForm) {
  EXPECT_THAT(Input("localhost:9021,multicast_8").addresses, SizeIs(2));
}

TEST(ShareCommand, CarriesALineOfEitherKind) {
  const auto command = ParseShareCommand("cmd=output,src_name=X,route=a:1");
  ASSERT_TRUE(command.has_value());
  EXPECT_TRUE(command->is_output);
  EXPECT_EQ(command->line, "src_name=X,route=a:1");
  EXPECT_FALSE(ParseShareCommand("cmd=input,route=localhost:1")->is_output);
}

TEST(ShareCommand, IsRefusedWithoutAKnownVerb) {
  EXPECT_FALSE(ParseShareCommand("src_name=X,route=a:1").has_value());
  EXPECT_FALSE(ParseShareCommand("cmd=erase").has_value());
}

TEST(ShareSecurity, TakesTheBlocksKeyUnlessTheLineSaysOtherwise) {
  const ShareSecurity block{.key_file = "fleet", .is_plain = true};
  ShareSecurity silent, plain{.is_plain = true}, own{.key_file = "other"};
  EXPECT_FALSE(Settle(silent, block) || Settle(plain, block) || Settle(own, block));
  EXPECT_EQ(silent.key_file, "fleet");
  EXPECT_FALSE(silent.is_plain);
  EXPECT_TRUE(plain.is_plain);
  EXPECT_EQ(own.key_file, "other");
}

TEST(ShareSecurity, IsPlainOnlyIfAsked) {
  ShareSecurity line;
  const auto error = Settle(line, {});
  ASSERT_TRUE(error.has_value());
  EXPECT_THAT(error->text, HasSubstr("allow_plain_routes = true"));
  EXPECT_FALSE(line.is_plain);
  EXPECT_FALSE(Settle(line, {.is_plain = true}));
  EXPECT_TRUE(line.is_plain);
}

}  // namespace
}  // namespace limpet
