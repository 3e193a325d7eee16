/*
 * Stand-in for a base on ROS 2, with Fast DDS: what ROS 2 itself uses by default, and another vendor's than Rosy's.
 *
 * Written from the message definitions of common_interfaces, kobuki_ros_interfaces and turtlebot3_msgs, from REP 2003 (quality of service) and from the article
 * "Topic and Service name mapping to DDS" of design.ros2.org; it shares nothing with Rosy.
 *
 * In: domain, namespace ("" for none), `kobuki` or `turtlebot3`, and words: `stamped` takes TwistStamped, `best_effort` publishes so, `no_watchdog` keeps the last
 * velocity. On standard input `mark`, `bump 0|1`, `quit`. Out: on standard output `ready`, `seen N` for a change in the number of writers of its velocity, `got X Z AGE`
 * (m/s, rad/s, s since the message's stamp, -1 without one), `watchdog` when 0.6 s pass after a velocity that was not zero, after `mark` `marked`, as soon as it
 * drives, and then `stood SECONDS`, by its own clock; `called NAME VALUE`.
 *
 * A Kobuki has the action AutoDocking, by the article "Actions" of design.ros2.org, the definitions of action_msgs, and AutoDocking.action: on standard input
 * `rejects` for the goals that come, `approach STATE` for feedback, `end STATUS TEXT`; out `goal accepted`, `goal rejected`, `cancel asked`. Its answers say whose
 * they are in the way of DDS-RPC 1.0, 7.8.2, as rmw_fastrtps_cpp does.
 */
#include "fast_dds.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <set>
#include <thread>

using Clock = std::chrono::steady_clock;

static std::mutex guard;
static double speed = 0, turn = 0;
static Clock::time_point told;
static bool moving = false, marking = false, counting = false;
static Clock::time_point marked;

/* A service whose answers may come later. It waits until somebody hears them, as rmw_fastrtps_cpp does for its own clients. */
struct Service {
  DataWriter *replies = nullptr;
  void answer(const SampleInfo &to, Bytes bytes) {
    std::thread([this, to, bytes]() mutable {
      PublicationMatchedStatus status;
      do {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        replies->get_publication_matched_status(status);
      } while (status.current_count == 0);
      eprosima::fastrtps::rtps::WriteParams whose;
      whose.related_sample_identity(to.sample_identity);
      replies->write(&bytes, whose);
    }).detach();
  }
};

/* The action of a Kobuki: one goal at a time. */
struct Docking {
  using Ident = std::array<uint8_t, 16>;
  Ident goal{};
  int8_t status = 0;
  std::string text;
  bool rejects = false, asked = false;
  SampleInfo who;
  Service send, result, cancel;
  DataWriter *feedback = nullptr, *states = nullptr;

  void accept(Bytes &bytes, const SampleInfo &info) {
    bool accepts = !rejects;
    if (accepts) decode(bytes, [&](Cdr &cdr) { cdr >> goal; }), asked = false, move(2);
    say("goal %s", accepts ? "accepted" : "rejected");
    send.answer(info, encoded([&](Cdr &cdr) { cdr << accepts << int32_t(0) << uint32_t(0); }));
  }
  void ask(const SampleInfo &info) {
    who = info, asked = true;
    if (status > 3) tell();
  }
  void give_up(Bytes &bytes, const SampleInfo &info) {
    Ident which;
    decode(bytes, [&](Cdr &cdr) { cdr >> which; });
    cancel.answer(info, encoded([&](Cdr &cdr) { cdr << int8_t(0) << uint32_t(1) << which << int32_t(0) << uint32_t(0); }));
    if (which == goal) say("cancel asked"), end(5, "given up");
  }
  void approach(const std::string &state) {
    Bytes bytes = encoded([&](Cdr &cdr) { cdr << goal << state << std::string("on its way"); });
    feedback->write(&bytes);
  }
  void end(int how, const std::string &why) {
    text = why;
    move(how);
    if (asked) tell();
  }
  void move(int to) {
    status = to;
    Bytes bytes = encoded([&](Cdr &cdr) { cdr << uint32_t(1) << goal << int32_t(0) << uint32_t(0) << status; });
    states->write(&bytes);
  }
  void tell() {
    asked = false;
    result.answer(who, encoded([&](Cdr &cdr) { cdr << status << text; }));
  }
};

static double since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

static void drive(double v, double w) {
  speed = v, turn = w, told = Clock::now();
  moving = v != 0 || w != 0;
  if (moving && marking) marking = false, counting = true, marked = told, say("marked");
  if (!moving && counting) counting = false, say("stood %.3f", since(marked));
}

int main(int count, char **arguments) {
  std::string space = arguments[2], kind = arguments[3];
  std::set<std::string> words(arguments + 4, arguments + count);
  bool stamped = words.count("stamped"), kobuki = kind == "kobuki", watchdog = !words.count("no_watchdog");
  int domain = atoi(arguments[1]);
  auto *participant = DomainParticipantFactory::get_instance()->create_participant(domain, with_peers(domain));
  auto *publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
  auto *subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
  auto topic = [&](const std::string &name, const std::string &type) {
    TypeSupport(new Raw(type)).register_type(participant);
    return participant->create_topic(name, type, TOPIC_QOS_DEFAULT);
  };
  auto writer = [&](const std::string &name, const std::string &type) {
    DataWriterQos qos = DATAWRITER_QOS_DEFAULT;
    qos.reliability().kind = words.count("best_effort") ? BEST_EFFORT_RELIABILITY_QOS : RELIABLE_RELIABILITY_QOS;
    qos.history().depth = 5;
    return publisher->create_datawriter(topic("rt" + space + "/" + name, type), qos);
  };
  std::vector<Listener *> listeners;
  auto reader = [&](const std::string &name, const std::string &type, Listener *listener) {
    DataReaderQos qos = DATAREADER_QOS_DEFAULT;
    qos.reliability().kind = RELIABLE_RELIABILITY_QOS;
    listeners.push_back(listener);
    subscriber->create_datareader(topic(name, type), qos, listener);
  };

  auto *odometry = writer("odom", "nav_msgs::msg::dds_::Odometry_");
  auto *bumper = kobuki ? writer("events/bumper", "kobuki_ros_interfaces::msg::dds_::BumperEvent_") : nullptr;
  auto *scan = kobuki ? nullptr : writer("scan", "sensor_msgs::msg::dds_::LaserScan_");
  auto *battery = kobuki ? nullptr : writer("battery_state", "sensor_msgs::msg::dds_::BatteryState_");
  auto *sensors = kobuki ? nullptr : writer("sensor_state", "turtlebot3_msgs::msg::dds_::SensorState_");
  auto *velocity = new Listener;
  velocity->act = [&](Bytes &bytes) {
    double x = 0, y, z, a, b, c = 0, age = -1;
    decode(bytes, [&](Cdr &cdr) {
      if (stamped) {
        int32_t seconds;
        uint32_t nanoseconds;
        std::string frame;
        cdr >> seconds >> nanoseconds >> frame;
        age = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count() - seconds - nanoseconds * 1e-9;
      }
      cdr >> x >> y >> z >> a >> b >> c;
    });
    std::lock_guard<std::mutex> lock(guard);
    say("got %g %g %.3f", x, c, age);
    /* As the controllers of ros2_control do: a velocity without a time, or with an old one, is none. A base without a watchdog takes every one. */
    if (!stamped || !watchdog || std::fabs(age) < 0.5) drive(x, c);
  };
  velocity->matched = [](int writers) { say("seen %d", writers); };
  reader("rt" + space + (kobuki ? "/commands/velocity" : "/cmd_vel"), stamped ? "geometry_msgs::msg::dds_::TwistStamped_" : "geometry_msgs::msg::dds_::Twist_", velocity);
  auto serves = [&](Service &service, const std::string &name, const std::string &type, std::function<void(Bytes &, const SampleInfo &)> serve) {
    service.replies = publisher->create_datawriter(topic("rr" + space + name + "Reply", type + "Response_"), DATAWRITER_QOS_DEFAULT);
    auto *requests = new Listener;
    requests->serve = [serve](Bytes &bytes, const SampleInfo &info) {
      std::lock_guard<std::mutex> lock(guard);
      serve(bytes, info);
    };
    reader("rq" + space + name + "Request", type + "Request_", requests);
  };
  static Service power;
  static Docking docking;
  if (!kobuki) {
    serves(power, "/motor_power", "std_srvs::srv::dds_::SetBool_", [](Bytes &bytes, const SampleInfo &info) {
      bool on;
      decode(bytes, [&](Cdr &cdr) { cdr >> on; });
      say("called motor_power %d", on);
      power.answer(info, encoded([](Cdr &cdr) { cdr << true << std::string("on"); }));
    });
  } else {
    std::string place = "/auto_docking_action/_action/", type = "kobuki_ros_interfaces::action::dds_::AutoDocking_";
    DataWriterQos latched = DATAWRITER_QOS_DEFAULT;
    latched.durability().kind = TRANSIENT_LOCAL_DURABILITY_QOS;
    docking.states = publisher->create_datawriter(topic("rt" + space + place + "status", "action_msgs::msg::dds_::GoalStatusArray_"), latched);
    docking.feedback = writer(place.substr(1) + "feedback", type + "FeedbackMessage_");
    serves(docking.result, place + "get_result", type + "GetResult_", [](Bytes &, const SampleInfo &info) { docking.ask(info); });
    serves(docking.cancel, place + "cancel_goal", "action_msgs::srv::dds_::CancelGoal_", [](Bytes &bytes, const SampleInfo &info) { docking.give_up(bytes, info); });
    serves(docking.send, place + "send_goal", type + "SendGoal_", [](Bytes &bytes, const SampleInfo &info) { docking.accept(bytes, info); });
  }

  std::thread([&] {
    double x = 0, y = 0, heading = 0, step = 0.02;
    auto next = Clock::now();
    for (int n = 0;; n++) {
      std::this_thread::sleep_until(next += std::chrono::milliseconds(20));
      double v, w;
      {
        std::lock_guard<std::mutex> lock(guard);
        if (moving && watchdog && since(told) > 0.6) say("watchdog"), drive(0, 0);
        v = speed, w = turn;
      }
      heading += w * step, x += v * step * cos(heading), y += v * step * sin(heading);
      auto header = [&](Cdr &cdr, const char *frame) { cdr << int32_t(n / 50 + 1) << uint32_t(0) << std::string(frame); };
      Bytes bytes = encoded([&](Cdr &cdr) {
        header(cdr, "odom");
        cdr << std::string("base_footprint") << x << y << 0.0 << 0.0 << 0.0 << sin(heading / 2) << cos(heading / 2);
        for (int i = 0; i < 36; i++) cdr << std::nan("");
        cdr << v << 0.0 << 0.0 << 0.0 << 0.0 << w;
        for (int i = 0; i < 36; i++) cdr << 0.0;
      });
      odometry->write(&bytes);
      if (scan && n % 10 == 0) {
        Bytes beams = encoded([&](Cdr &cdr) {
          header(cdr, "base_scan");
          cdr << 0.0f << 6.28f << 0.0175f << 0.0f << 0.2f << 0.12f << 3.5f << uint32_t(360);
          for (int i = 0; i < 360; i++) cdr << INFINITY;
          cdr << uint32_t(0);
        });
        scan->write(&beams);
        Bytes state = encoded([&](Cdr &cdr) {
          header(cdr, "");
          cdr << uint8_t(0) << 0.0f << 0.0f << 0.0f << uint8_t(0) << uint8_t(0) << true << int32_t(0) << int32_t(0) << 11.9f;
        });
        sensors->write(&state);
        /* voltage, temperature, current, charge, capacity, design capacity, percentage; three states; present; cells; location, serial number. */
        Bytes charge = encoded([&](Cdr &cdr) {
          header(cdr, "");
          cdr << 11.94f << NAN << NAN << NAN << NAN << 1.8f << 0.87f << uint8_t(0) << uint8_t(0) << uint8_t(0) << true << uint32_t(0) << uint32_t(0);
          cdr << std::string() << std::string();
        });
        battery->write(&charge);
      }
    }
  }).detach();

  say("ready");
  for (std::string word; std::cin >> word && word != "quit";) {
    std::lock_guard<std::mutex> lock(guard);
    if (word == "mark") {
      marking = true;
      if (moving) drive(speed, turn);
    } else if (word == "rejects") {
      docking.rejects = true;
    } else if (word == "approach") {
      std::string state;
      std::cin >> state;
      docking.approach(state);
    } else if (word == "end") {
      int status;
      std::string text;
      std::cin >> status >> text;
      docking.end(status, text);
    } else if (word == "bump" && bumper) {
      int state;
      std::cin >> state;
      Bytes bytes = encoded([&](Cdr &cdr) { cdr << uint8_t(0) << uint8_t(state); });
      bumper->write(&bytes);
    }
  }
  fflush(stdout);
  _Exit(0);
}
