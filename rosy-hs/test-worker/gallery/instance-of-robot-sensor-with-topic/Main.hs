instance Sensor Velocity where
  sensor = topic "/v" "geometry_msgs/Twist" ((\x -> Velocity x 0) <$> field "linear.x")

accelerate :: Velocity -> Velocity
accelerate (Velocity v w) = Velocity (v + 0.5) w

main = simulate accelerate
