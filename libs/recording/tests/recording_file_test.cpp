// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <string>
#include <vector>

#include "some_samples.h"

namespace nazori::recording {
namespace {

using haptics::ServoSample;
using testing::HasSubstr;

Session some_session() {
  Session session;
  session.device.name = "Touch / PHANTOM Omni (simulated)";
  session.device.rate_hz = 4000;
  session.device.has_force = true;
  session.device.limits.max_force_n = 7.5;
  session.device.limits.hand_damping_n_s_m = 1.25;
  session.shape = {0.2, 0.015};
  session.character = "休";
  session.start_ns = 1'700'000'000'123'456'789;
  for (std::size_t i = 0; i < session.id.size(); ++i) session.id[i] = static_cast<std::uint8_t>(i * 17);
  return session;
}

std::string recording_of(const std::vector<ServoSample>& samples, bool finished) {
  const auto header = encode_header(some_session());
  std::vector<std::uint8_t> bytes(header.begin(), header.end());
  for (const ServoSample& sample : samples) encode_record(sample, bytes);
  if (finished) encode_end(samples.size(), 3, false, bytes);
  return {bytes.begin(), bytes.end()};
}

struct Read {
  std::vector<ServoSample> samples;
  RecordingEnd end;
};

Read read(const std::string& bytes) {
  auto reader = RecordingReader::from(memory_source(bytes, "a.nzr"));
  Read got;
  if (!reader) {
    ADD_FAILURE() << base::to_line(reader.error());
    return got;
  }
  std::vector<ServoSample> some(7);
  while (const std::size_t count = *reader->read(some))
    got.samples.insert(got.samples.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
  got.end = reader->end();
  return got;
}

std::string trouble(const std::string& bytes) {
  const auto reader = RecordingReader::from(memory_source(bytes, "a.nzr"));
  return reader ? "" : base::to_line(reader.error());
}

TEST(RecordingFile, SaysWhatItWasRecordedWith) {
  const std::string bytes = recording_of({}, true);
  const auto reader = RecordingReader::from(memory_source(bytes, "a.nzr"));
  ASSERT_TRUE(reader);
  const Session& got = reader->session();
  const Session expected = some_session();
  EXPECT_EQ(got.device.name, expected.device.name);
  EXPECT_EQ(got.device.rate_hz, 4000);
  EXPECT_TRUE(got.device.has_force);
  EXPECT_EQ(got.device.limits.max_force_n, 7.5);
  EXPECT_EQ(got.device.limits.hand_damping_n_s_m, 1.25);
  EXPECT_EQ(got.shape.width_m, 0.2);
  EXPECT_EQ(got.shape.depth_m, 0.015);
  EXPECT_EQ(got.character, "休");
  EXPECT_EQ(got.start_ns, expected.start_ns);
  EXPECT_EQ(got.id, expected.id);
}

TEST(RecordingFile, GivesBackEverySampleBitForBit) {
  const auto samples = test::some_samples(5000);
  const Read got = read(recording_of(samples, true));
  ASSERT_EQ(got.samples.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) ASSERT_TRUE(test::same(got.samples[i], samples[i])) << i;
  EXPECT_TRUE(got.end.finished);
  EXPECT_FALSE(got.end.recovered);
  EXPECT_EQ(got.end.samples, samples.size());
  EXPECT_EQ(got.end.lost, 3U);
  EXPECT_EQ(got.end.damaged, 0U);
  EXPECT_EQ(got.end.trailing_bytes, 0U);
}

// The layout that docs/file-formats.md promises, read without any of our code.
TEST(RecordingFile, LiesInTheFileAsDocumented) {
  const auto samples = test::some_samples(2);
  const std::string bytes = recording_of(samples, true);
  ASSERT_EQ(bytes.size(), 512U + 3 * 152U);
  const auto number = [&bytes]<class T>(std::size_t at, T value) {
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    return value;
  };
  EXPECT_EQ(bytes.substr(0, 8), "\x89NZR\r\n\x1A\n");
  EXPECT_EQ(bytes.substr(8, 4), "\x04\x03\x02\x01");
  EXPECT_EQ(number(12, std::uint16_t{}), 1);
  EXPECT_EQ(number(16, std::uint32_t{}), 512U);
  EXPECT_EQ(number(20, std::uint32_t{}), 152U);
  EXPECT_EQ(number(24, double{}), 4000);
  EXPECT_EQ(number(32, std::int64_t{}), 1'700'000'000'123'456'789);
  EXPECT_EQ(number(40, double{}), 0.2);
  EXPECT_EQ(number(48, double{}), 0.015);
  EXPECT_EQ(number(56, double{}), 7.5);
  EXPECT_EQ(number(112, double{}), 1.25);
  EXPECT_EQ(number(120, std::uint32_t{}), 1U);
  EXPECT_EQ(bytes.substr(160, 6), "Touch ");
  EXPECT_EQ(bytes.substr(288, 4), std::string("休") + '\0');
  EXPECT_EQ(number(508, std::uint32_t{}), ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), 508));
  const std::size_t second = 512 + 152;
  EXPECT_EQ(number(second, std::uint64_t{}), samples[1].tick);
  EXPECT_EQ(number(second + 8, double{}), samples[1].time_s);
  EXPECT_EQ(number(second + 16, double{}), samples[1].device_m.x);
  EXPECT_EQ(number(second + 56, double{}), samples[1].proxy_m.z);
  EXPECT_EQ(number(second + 80, double{}), samples[1].force_n.z);
  EXPECT_EQ(number(second + 88, double{}), samples[1].guide_m.x);
  EXPECT_EQ(number(second + 112, double{}), samples[1].progress_m);
  EXPECT_EQ(number(second + 120, double{}), samples[1].off_m);
  EXPECT_EQ(number(second + 128, std::int32_t{}), samples[1].stroke);
  EXPECT_EQ(number(second + 132, std::int32_t{}), samples[1].guided_stroke);
  EXPECT_EQ(number(second + 136, std::int32_t{}), samples[1].done_stroke);
  EXPECT_EQ(number(second + 140, std::uint32_t{}), samples[1].buttons);
  EXPECT_EQ(number(second + 144, std::uint16_t{}), samples[1].events);
  EXPECT_EQ(number(second + 146, std::uint16_t{}), samples[1].touching ? 1 : 0);
  EXPECT_EQ(number(second + 148, std::uint32_t{}),
            ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + second), 148));
  EXPECT_EQ(number(second + 152, std::uint64_t{}), 2U);
  EXPECT_EQ(number(second + 152 + 8, std::uint64_t{}), 3U);
  EXPECT_EQ(number(second + 152 + 146, std::uint16_t{}), 0x8000);
}

TEST(RecordingFile, CutOffAnywhereIsReadToItsLastWholeRecord) {
  const auto samples = test::some_samples(10);
  const std::string whole = recording_of(samples, true);
  for (std::size_t length = kHeaderBytes; length < whole.size(); ++length) {
    const Read got = read(whole.substr(0, length));
    const std::size_t records = (length - kHeaderBytes) / kRecordBytes;
    ASSERT_EQ(got.samples.size(), records);
    for (std::size_t i = 0; i < records; ++i) ASSERT_TRUE(test::same(got.samples[i], samples[i]));
    ASSERT_FALSE(got.end.finished);
    ASSERT_EQ(got.end.trailing_bytes, (length - kHeaderBytes) % kRecordBytes);
  }
}

TEST(RecordingFile, LeavesOutWhatIsDamagedAndCountsIt) {
  const auto samples = test::some_samples(10);
  std::string bytes = recording_of(samples, true);
  for (const std::size_t at : {std::size_t{0}, std::size_t{50}, kRecordBytes - 1}) {
    std::string hurt = bytes;
    hurt[kHeaderBytes + 4 * kRecordBytes + at] ^= 1;
    const Read got = read(hurt);
    EXPECT_EQ(got.end.damaged, 1U);
    ASSERT_EQ(got.samples.size(), 9U);
    EXPECT_EQ(got.samples[4].tick, samples[5].tick);
    EXPECT_TRUE(got.end.finished);
  }
}

TEST(RecordingFile, RefusesWhatIsNoRecordingInOneLine) {
  EXPECT_THAT(trouble(""), HasSubstr("a.nzr: is not a recording"));
  EXPECT_THAT(trouble("t,x,y,z\n0,0,0,0\n"), HasSubstr("is not a recording"));
  const std::string good = recording_of({}, true);
  EXPECT_THAT(trouble(good.substr(0, 511)), HasSubstr("within its header"));
  for (std::size_t at = 8; at < kHeaderBytes; ++at) {
    std::string hurt = good;
    hurt[at] ^= 0x10;
    EXPECT_NE(trouble(hurt), "") << at;
  }
  std::string later = good;
  later[12] = 2;
  EXPECT_THAT(trouble(later), HasSubstr("version 2"));
}

TEST(RecordingFile, CutsLongNamesBetweenCharacters) {
  Session session = some_session();
  session.character.clear();
  for (int i = 0; i < 100; ++i) session.character += "休";
  const auto header = encode_header(session);
  const auto got = decode_header(header, "a");
  ASSERT_TRUE(got);
  EXPECT_EQ(got->character.size(), 126U);
  EXPECT_TRUE(session.character.starts_with(got->character));
}

}  // namespace
}  // namespace nazori::recording
