main = simulate $ do
  1. drive 50
  2. turn 90
