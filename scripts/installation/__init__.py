"""Packages of an installed Rosy: a Debian package and a folder that starts without internet."""
