-- The light is on in every second second.
blink :: Clock -> Led1
blink Clock {seconds = second}
  | even second = Led1 Orange
  | otherwise = Led1 Black

main :: IO ()
main = simulate blink
