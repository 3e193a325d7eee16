/*
 * What the peers with Fast DDS share: messages as their bytes, written and read by hand as the definitions say; a listener; lines on standard output.
 */
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <fastrtps/utils/IPFinder.h>
#include <fastrtps/utils/IPLocator.h>

#include <cstdio>
#include <cstring>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

using namespace eprosima::fastdds::dds;
using eprosima::fastcdr::Cdr;
using Bytes = std::vector<char>;

/* A message is its bytes: they are written and read by hand, as the definitions say. */
struct Raw : TopicDataType {
  explicit Raw(const std::string &name) {
    setName(name.c_str());
    m_typeSize = 4096;
    m_isGetKeyDefined = false;
  }
  bool serialize(void *data, eprosima::fastrtps::rtps::SerializedPayload_t *payload) override {
    auto *bytes = static_cast<Bytes *>(data);
    payload->encapsulation = CDR_LE;
    payload->length = bytes->size();
    memcpy(payload->data, bytes->data(), bytes->size());
    return true;
  }
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t *payload, void *data) override {
    static_cast<Bytes *>(data)->assign(payload->data, payload->data + payload->length);
    return true;
  }
  std::function<uint32_t()> getSerializedSizeProvider(void *data) override {
    return [data] { return static_cast<uint32_t>(static_cast<Bytes *>(data)->size()); };
  }
  void *createData() override { return new Bytes; }
  void deleteData(void *data) override { delete static_cast<Bytes *>(data); }
  bool getKey(void *, eprosima::fastrtps::rtps::InstanceHandle_t *, bool) override { return false; }
};

static Bytes encoded(const std::function<void(Cdr &)> &write) {
  Bytes bytes(4096);
  eprosima::fastcdr::FastBuffer buffer(bytes.data(), bytes.size());
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  write(cdr);
  bytes.resize(cdr.getSerializedDataLength());
  return bytes;
}

static void decode(Bytes &bytes, const std::function<void(Cdr &)> &read) {
  eprosima::fastcdr::FastBuffer buffer(bytes.data(), bytes.size());
  Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
  cdr.read_encapsulation();
  read(cdr);
}

static std::mutex saying;
template <typename... Words> static void say(const char *format, Words... words) {
  std::lock_guard<std::mutex> lock(saying);
  printf(format, words...);
  putchar('\n');
  fflush(stdout);
}

struct Listener : DataReaderListener {
  std::function<void(Bytes &)> act = [](Bytes &) {};
  std::function<void(Bytes &, const SampleInfo &)> serve = [](Bytes &, const SampleInfo &) {};
  std::function<void(int)> matched = [](int) {};
  void on_data_available(DataReader *reader) override {
    Bytes bytes;
    SampleInfo info;
    while (reader->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK)
      if (info.valid_data) act(bytes), serve(bytes, info);
  }
  void on_subscription_matched(DataReader *, const SubscriptionMatchedStatus &status) override { matched(status.current_count); }
};

/*
 * Fast DDS 2.9 with statistics aborts when it sends to a participant that it is just discovering ("it != collection_.end()", mended by its pull request 3169):
 * the channel to an address is entered too late. So the addresses of participants on this computer are initial peers (ports: DDSI-RTPS 2.5, 9.6.2.3).
 */
static DomainParticipantQos with_peers(int domain) {
  namespace rtps = eprosima::fastrtps::rtps;
  DomainParticipantQos qos = PARTICIPANT_QOS_DEFAULT;
  auto add = [&](const std::string &address, int port) {
    rtps::Locator_t locator;
    rtps::IPLocator::createLocator(LOCATOR_KIND_UDPv4, address, 7400 + 250 * domain + port, locator);
    qos.wire_protocol().builtin.initialPeersList.push_back(locator);
  };
  add("239.255.0.1", 0);
  std::vector<rtps::IPFinder::info_IP> found;
  rtps::IPFinder::getIPs(&found, true);
  for (auto &own : found)
    if (own.type == rtps::IPFinder::IP4 || own.type == rtps::IPFinder::IP4_LOCAL)
      for (int port = 10; port < 30; port++) add(own.name, port);
  return qos;
}
