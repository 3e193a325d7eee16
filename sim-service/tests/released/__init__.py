"""What released versions have stored, in a folder for each, and tests that this version reads it."""
