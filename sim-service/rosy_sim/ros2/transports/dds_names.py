"""
Names of ROS 2 in DDS, and back: ``/cmd_vel`` is ``rt/cmd_vel``, ``geometry_msgs/Twist`` is
``geometry_msgs::msg::dds_::Twist_`` (design.ros2.org, "Topic and Service name mapping to DDS"). Pure.
"""

from __future__ import annotations

import re

__all__ = [
    "dds_message_type",
    "dds_request_topic",
    "dds_request_type",
    "dds_topic",
    "ros_service",
    "ros_topic",
    "ros_type",
]

_MESSAGE = re.compile(r"(\w+)::msg::dds_::(\w+)_")
_REQUEST = re.compile(r"(\w+)::srv::dds_::(\w+)_Request_")


def dds_topic(topic: str) -> str:
    """The DDS topic of a topic's absolute name."""
    return f"rt{topic}"


def dds_message_type(kind: str) -> str:
    """The DDS type of a message type without ``msg``: ``geometry_msgs/Twist``."""
    package, _, name = kind.partition("/")
    return f"{package}::msg::dds_::{name}_"


def dds_request_topic(service: str) -> str:
    """The DDS topic of a service's requests."""
    return f"rq{service}Request"


def dds_request_type(kind: str) -> str:
    """The DDS type of the requests of a service type without ``srv``: ``std_srvs/SetBool``."""
    package, _, name = kind.partition("/")
    return f"{package}::srv::dds_::{name}_Request_"


def ros_topic(name: str) -> str | None:
    """The topic of a DDS topic; ``None`` when it is none of ROS 2."""
    return name.removeprefix("rt") if name.startswith("rt/") else None


def ros_service(name: str) -> str | None:
    """The service of the DDS topic of its requests."""
    return (
        name.removeprefix("rq").removesuffix("Request") if name.startswith("rq/") and name.endswith("Request") else None
    )


def ros_type(name: str) -> str | None:
    """The type of a message or of a request, without ``msg`` and ``srv``."""
    found = _MESSAGE.fullmatch(name) or _REQUEST.fullmatch(name)
    return f"{found[1]}/{found[2]}" if found else None
