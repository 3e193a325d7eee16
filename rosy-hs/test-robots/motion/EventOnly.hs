go :: Button -> Maybe Velocity
go (Button Button0 Pressed) = Just (Velocity 0.2 0)
go (Button Button1 Pressed) = Just (Velocity 0.1 0.5)
go _ = Nothing

main :: IO ()
main = simulate go
