// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "piece_source.h"
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

// The layout of docs/file-formats.md, read independently of the code under test.
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

TEST(RecordingFile, HasTheTenNumbersOfTheTabletAndTheDeviceInTheirPlaces) {
  Session session = some_session();
  session.shape = {1.5, 2.5};
  session.device.limits = {3.5, 4.5, 5.5, 6.5, 7.5, 8.5, 9.5, 10.5};
  session.device.has_force = false;
  session.tip_radius_m = 0.0015;
  const auto bytes = encode_header(session);
  double tip_m = 0;
  std::memcpy(&tip_m, bytes.data() + 144, 8);
  EXPECT_EQ(tip_m, 0.0015);
  EXPECT_EQ(decode_header(bytes, "a.nzr")->tip_radius_m, 0.0015);
  for (std::size_t i = 0; i < 10; ++i) {
    double number = 0;
    std::memcpy(&number, bytes.data() + 40 + 8 * i, 8);
    EXPECT_EQ(number, 1.5 + static_cast<double>(i)) << i;
  }
  EXPECT_EQ(bytes[14], 1) << "the minor version";
  for (const auto& [from, to] : {std::pair{120U, 128U}, std::pair{152U, 160U}, std::pair{416U, 508U}})
    for (std::size_t at = from; at < to; ++at) EXPECT_EQ(bytes[at], 0) << at;
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(bytes[128 + i], i * 17);
  const auto read = decode_header(bytes, "a.nzr");
  ASSERT_TRUE(read);
  const auto& l = read->device.limits;
  EXPECT_EQ(std::tie(read->shape.width_m, read->shape.depth_m), std::make_tuple(1.5, 2.5));
  EXPECT_EQ(std::tie(l.max_force_n, l.continuous_force_n, l.max_stiffness_n_m, l.max_damping_n_s_m),
            std::make_tuple(3.5, 4.5, 5.5, 6.5));
  EXPECT_EQ(std::tie(l.own_damping_n_s_m, l.max_slew_n_s, l.delay_s, l.hand_damping_n_s_m),
            std::make_tuple(7.5, 8.5, 9.5, 10.5));
  EXPECT_FALSE(read->device.has_force);
}

TEST(RecordingFile, ARecordHasEveryNumberOfItsVectorsInItsPlace) {
  ServoSample sample;
  sample.device_m = {1, 2, 3};
  sample.proxy_m = {4, 5, 6};
  sample.force_n = {7, 8, 9};
  sample.guide_m = {10, 11, 12};
  sample.touching = true;
  std::vector<std::uint8_t> bytes;
  encode_record(sample, bytes);
  ASSERT_EQ(bytes.size(), kRecordBytes);
  for (std::size_t i = 0; i < 12; ++i) {
    double number = 0;
    std::memcpy(&number, bytes.data() + 16 + 8 * i, 8);
    EXPECT_EQ(number, 1.0 + static_cast<double>(i));
  }
  EXPECT_EQ(bytes[146], 1);
  bytes.clear();
  encode_end(0x0102030405060708, 0x1112131415161718, true, bytes);
  EXPECT_EQ(bytes[146], 2) << "recovered";
  EXPECT_EQ(bytes[147], 0x80) << "the end";
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(bytes[i], 8 - i);
    EXPECT_EQ(bytes[8 + i], 0x18 - i);
  }
  for (std::size_t at = 16; at < 146; ++at) EXPECT_EQ(bytes[at], 0) << at;
}

TEST(RecordingFile, WhatFollowsTheEndIsNotRead) {
  const auto samples = test::some_samples(3);
  const std::string whole = recording_of(samples, true);
  const Read got = read(whole + whole.substr(kHeaderBytes, kRecordBytes));
  EXPECT_EQ(got.samples.size(), 3U);
  EXPECT_TRUE(got.end.finished);
  std::vector<std::uint8_t> end;
  encode_end(3, 9, true, end);
  const Read recovered = read(recording_of(samples, false) + std::string(end.begin(), end.end()));
  EXPECT_TRUE(recovered.end.recovered);
  EXPECT_EQ(recovered.end.lost, 9U);
}

TEST(RecordingFile, IsReadAsWellInPieces) {
  const auto samples = test::some_samples(300);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{100}, kRecordBytes, std::size_t{1000}}) {
    auto reader =
        RecordingReader::from(std::make_unique<test::PieceSource>(recording_of(samples, true), piece));
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->progress(), 0) << "of a length that nobody knows";
    std::vector<ServoSample> got(301);
    got.resize(reader->read(got).value());
    ASSERT_EQ(got.size(), samples.size());
    for (std::size_t i = 0; i < got.size(); ++i) ASSERT_TRUE(test::same(got[i], samples[i]));
    EXPECT_TRUE(reader->end().finished);
    EXPECT_EQ(reader->progress(), 0);
  }
}

TEST(RecordingFile, AReadThatFailsIsTold) {
  EXPECT_EQ(RecordingReader::from(std::make_unique<test::PieceSource>("", 10, 0, true)).error().what,
            "the plug was pulled");
  auto reader = RecordingReader::from(
      std::make_unique<test::PieceSource>(recording_of(test::some_samples(3), false), 1000, 0, true));
  ASSERT_TRUE(reader);
  std::vector<ServoSample> got(3);
  EXPECT_EQ(reader->read(got).value(), 3U);
  EXPECT_EQ(reader->read(got).error().what, "the plug was pulled");
}

TEST(RecordingFile, ProgressIsTheShareOfTheFileThatWasRead) {
  const std::string bytes = recording_of(test::some_samples(6000), true);
  const auto share = [&bytes](std::size_t records) {
    return static_cast<double>(kHeaderBytes + records * kRecordBytes) / static_cast<double>(bytes.size());
  };
  auto reader = RecordingReader::from(memory_source(bytes, "a.nzr"));
  ASSERT_TRUE(reader);
  EXPECT_DOUBLE_EQ(reader->progress(), share(0));
  std::vector<ServoSample> some(2500);
  for (const std::size_t records : {2500U, 5000U}) {
    ASSERT_EQ(reader->read(some).value(), 2500U);
    EXPECT_DOUBLE_EQ(reader->progress(), share(records));
  }
  ASSERT_EQ(reader->read(some).value(), 1000U);
  EXPECT_EQ(reader->progress(), 1);
  auto growing = RecordingReader::from(std::make_unique<test::PieceSource>(bytes, 1 << 20U, 1000));
  ASSERT_TRUE(growing);
  (void)growing->read(some);
  EXPECT_EQ(growing->progress(), 1) << "a file that has grown since";
}

/// A header that was changed on purpose, with a correct checksum.
std::array<std::uint8_t, kHeaderBytes> resealed(std::array<std::uint8_t, kHeaderBytes> bytes) {
  const auto sum = static_cast<std::uint32_t>(::crc32(0, bytes.data(), 508));
  std::memcpy(bytes.data() + 508, &sum, 4);
  return bytes;
}

TEST(RecordingFile, EveryKindOfWrongHeaderIsCalledByItsName) {
  const auto good = encode_header(some_session());
  const auto with = [&good]<class T>(std::size_t at, T value) {
    auto bytes = good;
    std::memcpy(bytes.data() + at, &value, sizeof(T));
    const auto session = decode_header(resealed(bytes), "a.nzr");
    return session ? base::Error{} : session.error();
  };
  using base::Errc;
  EXPECT_EQ(with(7, std::uint8_t{0}).what, "is not a recording");
  EXPECT_EQ(with(8, 0x04030201U), (base::Error{Errc::parse, "has its bytes in another order", "a.nzr", ""}));
  EXPECT_EQ(with(12, std::uint16_t{2}), (base::Error{Errc::schema, "is a recording of version 2", "a.nzr",
                                                     "this program reads version 1"}));
  EXPECT_EQ(with(14, std::uint16_t{9}), base::Error{}) << "a later minor version is read";
  const base::Error damaged{Errc::parse, "has a damaged header", "a.nzr", ""};
  EXPECT_EQ(with(16, 511U), damaged);
  EXPECT_EQ(with(20, 151U), damaged);
  auto torn = good;
  torn[300] ^= 1;
  EXPECT_EQ(decode_header(torn, "a.nzr").error(), damaged);
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double rate : {0.0, -1.0, std::nan(""), infinite, -infinite})
    EXPECT_EQ(with(24, rate), (base::Error{Errc::parse, "has no sensible rate", "a.nzr", ""})) << rate;
  EXPECT_EQ(decode_header(std::span(good).first(511), "a.nzr").error().what, "breaks off within its header");
  EXPECT_EQ(decode_header(std::span(good).first(7), "a.nzr").error().what, "is not a recording");
  EXPECT_EQ(decode_header(std::span(good).first(8), "a.nzr").error().what, "breaks off within its header");
}

TEST(RecordingFile, NamesFillTheirFieldsToTheLastByteButOne) {
  const auto read_back = [](const std::string& name) {
    Session session = some_session();
    session.device.name = session.character = name;
    const auto bytes = encode_header(session);
    EXPECT_EQ(bytes[160 + 127], 0);
    EXPECT_EQ(bytes[288 + 127], 0);
    const auto got = decode_header(bytes, "a").value();
    EXPECT_EQ(got.device.name, got.character);
    return got.character;
  };
  const std::string longest(127, 'a');
  EXPECT_EQ(read_back(longest), longest);
  EXPECT_EQ(read_back(longest + "b"), longest);
  EXPECT_EQ(read_back(std::string(126, 'a') + "é"), std::string(126, 'a')) << "no half of a character";
  EXPECT_EQ(read_back(std::string(125, 'a') + "éb"), std::string(125, 'a') + "é");
  EXPECT_EQ(read_back(std::string(200, '\x80')), "") << "no character begins anywhere";
  EXPECT_EQ(read_back("a\xFF"), "") << "a name that is not UTF-8 is none";
  EXPECT_EQ(read_back(""), "");
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
