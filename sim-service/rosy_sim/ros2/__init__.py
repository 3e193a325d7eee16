"""Robots on ROS 2, reached without ROS on this computer: a bridge between DDS or Zenoh and the rosbridge protocol."""
