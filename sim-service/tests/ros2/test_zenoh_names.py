"""Keys and tokens of rmw_zenoh; the tokens are those of its design document."""

from __future__ import annotations

from dataclasses import replace

import pytest

from rosy_sim.ros2.transports.dds_names import ros_service, ros_topic, ros_type
from rosy_sim.ros2.transports.graph import Graph, Quality
from rosy_sim.ros2.transports.zenoh_names import ZenohEndpoint, node_token, parse_token, token_for

HASH = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"

TALKER = (
    "@ros2_lv/0/8b20917502ee955ac4476e0266340d5c/0/10/MP/%/%/talker/%chatter/std_msgs::msg::dds_::String_/"
    f"{HASH}/::,7:,:,:,,"
)


def parsed(key: str) -> ZenohEndpoint:
    found = parse_token(key)
    assert found is not None
    return found


def test_a_token_is_a_topic_with_its_key() -> None:
    talker = parsed(TALKER)
    assert talker.key == f"0/chatter/std_msgs::msg::dds_::String_/{HASH}"
    assert talker.session == "8b20917502ee955ac4476e0266340d5c"
    assert not talker.is_reader
    endpoint = talker.endpoint("pi:7447")
    assert (ros_topic(endpoint.topic), ros_type(endpoint.type)) == ("/chatter", "std_msgs/String")
    assert endpoint.participant != replace(talker, session="cd").endpoint("pi:7447").participant
    assert (endpoint.quality, endpoint.host) == (Quality(True, False), "pi:7447")


def test_a_server_is_the_service_that_dds_has() -> None:
    server = parsed(
        "@ros2_lv/7/ab/3/22/SS/%/%lab/node/%lab%sound/std_srvs::srv::dds_::SetBool_/TypeHashNotSupported/::,10:,:,:,,"
    )
    assert server.key == "7/lab/sound/std_srvs::srv::dds_::SetBool_/TypeHashNotSupported"
    assert ros_service(server.endpoint("").topic) == "/lab/sound"
    assert Graph((), [server.endpoint("")]).services() == {"/lab/sound": "std_srvs/SetBool"}
    assert token_for(server, "cd", 2, "rosy").split("/")[5] == "SC"


@pytest.mark.parametrize(
    ("written", "quality"),
    [("2::,5:,:,:,,", Quality(False, False)), (":1:,1:,:,:,,", Quality(True, True)), ("strange", Quality(True, False))],
)
def test_what_a_token_offers(written: str, quality: Quality) -> None:
    assert parsed(TALKER.rpartition("/")[0] + f"/{written}").quality == quality


@pytest.mark.parametrize(
    "key", [node_token("0", "ab", "listener"), TALKER.replace("/MP/", "/SC/"), TALKER.rpartition("/")[0], "@ros2_lv/0"]
)
def test_nodes_clients_and_what_is_no_token_are_left_out(key: str) -> None:
    assert parse_token(key) is None


def test_the_own_token_names_the_same_topic_type_and_quality_from_the_other_side() -> None:
    for quality in (Quality(True, False), Quality(False, False), Quality(True, True)):
        talker = replace(parsed(TALKER), quality=quality)
        listener = parsed(token_for(talker, "cd", 3, "rosy"))
        assert listener == replace(talker, session="cd", kind="MS")
        assert listener.is_reader
