// SPDX-License-Identifier: MIT
#include "limpet/topics/map_tile.hpp"

#include <gtest/gtest.h>

#include "limpet/topics/mapping.hpp"

namespace limpet {
namespace {

TEST(MapTile, TravelsPackedAndComesOutAsItWas) {
  const std::string octree(5000, 'o');
  const MapTile tile = MapTile::Of({-3, 12}, octree);
  EXPECT_LT(tile.packed.size(), octree.size() / 10);
  const auto back = TopicCodec<MapTile>::Decode(TopicCodec<MapTile>::Encode(tile));
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, tile);
  EXPECT_EQ(*back->Octree(), octree);
}

TEST(MapTile, MaySayThatNothingIsKnownThereAnyMore) {
  const MapTile gone{.key = {1, 2}, .packed = {}};
  EXPECT_EQ(TopicCodec<MapTile>::Decode(TopicCodec<MapTile>::Encode(gone)), gone);
  EXPECT_FALSE(gone.Octree());
}

TEST(MapTile, TakesNothingElseForATile) {
  const auto decode = [](const std::string& bytes) {
    const auto* first = reinterpret_cast<const std::byte*>(bytes.data());
    return TopicCodec<MapTile>::Decode(Binary(first, first + bytes.size()));
  };
  EXPECT_FALSE(decode(""));
  EXPECT_FALSE(decode("LMT1\1"));
  EXPECT_FALSE(decode(std::string("LMT2\0\0\0\0\0\0\0\0", 12)));
  EXPECT_FALSE(decode(std::string("LMT1\0\0\0\0\0\0\0\0no gzip", 19)));
  EXPECT_FALSE(TopicCodec<MapTile>::Decode(Value(std::string("LMT1"))));
  MapTile cut = MapTile::Of({}, std::string(5000, 'o'));
  cut.packed.resize(cut.packed.size() / 2);
  EXPECT_FALSE(cut.Octree());
}

TEST(MapTileList, ReadsAsText) {
  const MapTileList list{.tiles = 3, .checksum = "00ff"};
  EXPECT_EQ(std::get<std::string>(TopicCodec<MapTileList>::Encode(list)), "tiles=3,xxh3_64=00ff");
  EXPECT_EQ(TopicCodec<MapTileList>::Decode(Value(std::string("tiles=3,xxh3_64=00ff"))), list);
}

}  // namespace
}  // namespace limpet
