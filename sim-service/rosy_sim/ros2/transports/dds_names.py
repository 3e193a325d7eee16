"""
Names of ROS 2 in DDS, and back: ``/cmd_vel`` is ``rt/cmd_vel``, ``geometry_msgs/Twist`` is
``geometry_msgs::msg::dds_::Twist_`` (design.ros2.org, "Topic and Service name mapping to DDS"). A service is a topic of
requests and one of replies; an action is three services and two topics below ``_action`` (design.ros2.org, "Actions").
Pure.
"""

from __future__ import annotations

import re

__all__ = [
    "dds_message_type",
    "dds_reply_topic",
    "dds_request_topic",
    "dds_topic",
    "ros_service",
    "ros_topic",
    "ros_type",
]

_MESSAGE = re.compile(r"(\w+)::(?:msg|action)::dds_::(\w+)_")
_REQUEST = re.compile(r"(\w+)::(?:srv|action)::dds_::(\w+)_Request_")

_OF_ACTIONS = ("_SendGoal_Request", "_SendGoal_Response", "_GetResult_Request", "_GetResult_Response")
"""Endings of the types of an action's services. No other type has an underscore (rosidl_adapter, parser.py)."""


def dds_topic(topic: str) -> str:
    """The DDS topic of a topic's absolute name."""
    return f"rt{topic}"


def dds_message_type(kind: str) -> str:
    """
    The DDS type of a message type without ``msg``, ``geometry_msgs/Twist``, or of a part of a service or an action:
    ``std_srvs/SetBool_Request``, ``nav2_msgs/NavigateToPose_FeedbackMessage``.
    """
    package, _, name = kind.partition("/")
    if name.endswith((*_OF_ACTIONS, "_FeedbackMessage")):
        place = "action"
    else:
        place = "srv" if name.endswith(("_Request", "_Response")) else "msg"
    return f"{package}::{place}::dds_::{name}_"


def dds_request_topic(service: str) -> str:
    """The DDS topic of a service's requests."""
    return f"rq{service}Request"


def dds_reply_topic(service: str) -> str:
    """The DDS topic of a service's replies."""
    return f"rr{service}Reply"


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
    found = _REQUEST.fullmatch(name) or _MESSAGE.fullmatch(name)
    return f"{found[1]}/{found[2]}" if found else None
