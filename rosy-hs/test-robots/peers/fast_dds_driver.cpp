/*
 * Stand-in for a program on ROS 2 that drives a robot, with Fast DDS: what teleop_twist_keyboard and RViz need of a base.
 *
 * Written from the message definitions of common_interfaces and geometry2, from REP 105 (frames) and from the article "Topic and Service name mapping to DDS" of
 * design.ros2.org; it shares nothing with Rosy.
 *
 * In: domain and words: `stamped` sends TwistStamped. On standard input `drive X Z` (m/s, rad/s), sent ten times a second from then on, and `quit`. Out: on standard
 * output `ready`; `odom FRAME CHILD X` (m) whenever x has changed by a centimetre, and at first; once for each transform `tf FRAME CHILD`; once `scan FRAME BEAMS`.
 */
#include "fast_dds.hpp"

#include <chrono>
#include <cmath>
#include <iostream>
#include <set>
#include <thread>

static std::mutex guard;
static double speed = 0, turn = 0;
static bool driving = false;

static std::string header(Cdr &cdr) {
  int32_t seconds;
  uint32_t nanoseconds;
  std::string frame;
  cdr >> seconds >> nanoseconds >> frame;
  return frame;
}

int main(int count, char **arguments) {
  std::set<std::string> words(arguments + 2, arguments + count);
  bool stamped = words.count("stamped");
  int domain = atoi(arguments[1]);
  auto *participant = DomainParticipantFactory::get_instance()->create_participant(domain, with_peers(domain));
  auto *publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
  auto *subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
  auto topic = [&](const std::string &name, const std::string &type) {
    TypeSupport(new Raw(type)).register_type(participant);
    return participant->create_topic(name, type, TOPIC_QOS_DEFAULT);
  };
  auto read = [&](const std::string &name, const std::string &type, const std::function<void(Cdr &)> &act) {
    DataReaderQos qos = DATAREADER_QOS_DEFAULT;
    qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
    auto *listener = new Listener;
    listener->act = [act](Bytes &bytes) { decode(bytes, act); };
    subscriber->create_datareader(topic(name, type), qos, listener);
  };
  read("rt/odom", "nav_msgs::msg::dds_::Odometry_", [](Cdr &cdr) {
    static double told = NAN;
    std::string frame = header(cdr), child;
    double x;
    cdr >> child >> x;
    if (!(std::fabs(x - told) < 0.01)) told = x, say("odom %s %s %.3f", frame.c_str(), child.c_str(), x);
  });
  read("rt/tf", "tf2_msgs::msg::dds_::TFMessage_", [](Cdr &cdr) {
    static std::set<std::string> told;
    uint32_t count;
    cdr >> count;
    for (uint32_t i = 0; i < count; i++) {
      std::string frame = header(cdr), child;
      double parts[7];
      cdr >> child;
      for (double &part : parts) cdr >> part;
      if (told.insert(child).second) say("tf %s %s", frame.c_str(), child.c_str());
    }
  });
  read("rt/scan", "sensor_msgs::msg::dds_::LaserScan_", [](Cdr &cdr) {
    static bool told = false;
    std::string frame = header(cdr);
    float part;
    uint32_t beams;
    for (int i = 0; i < 7; i++) cdr >> part;
    cdr >> beams;
    if (!told) told = true, say("scan %s %u", frame.c_str(), beams);
  });
  DataWriterQos qos = DATAWRITER_QOS_DEFAULT;
  qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
  auto *velocity = publisher->create_datawriter(
      topic("rt/cmd_vel", stamped ? "geometry_msgs::msg::dds_::TwistStamped_" : "geometry_msgs::msg::dds_::Twist_"), qos);
  std::thread([&] {
    for (;; std::this_thread::sleep_for(std::chrono::milliseconds(100))) {
      std::lock_guard<std::mutex> lock(guard);
      if (!driving) continue;
      Bytes bytes = encoded([&](Cdr &cdr) {
        if (stamped) cdr << int32_t(0) << uint32_t(0) << std::string("base_footprint");
        cdr << speed << 0.0 << 0.0 << 0.0 << 0.0 << turn;
      });
      velocity->write(&bytes);
    }
  }).detach();

  say("ready");
  for (std::string word; std::cin >> word && word != "quit";) {
    std::lock_guard<std::mutex> lock(guard);
    if (word == "drive") std::cin >> speed >> turn, driving = true;
  }
  fflush(stdout);
  _Exit(0);
}
