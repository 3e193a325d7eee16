-- Messages of the first kind are more important than those of the second.
newtype M1 a = M1 a

newtype M2 a = M2 a

-- Until then, only important messages pass.
newtype M = M Seconds

mux :: Seconds -> Memory M -> Either (M1 a) (M2 a) -> Maybe (a, Memory M)
mux now _ (Left (M1 message)) = Just (message, Memory (M (now + 1)))
mux now (Memory (M end)) (Right (M2 message))
  | now > end = Just (message, Memory (M end))
  | otherwise = Nothing

muxVelocity ::
  Seconds ->
  Memory M ->
  Either (M1 Velocity) (M2 Velocity) ->
  Maybe (Velocity, Memory M)
muxVelocity = mux

button :: Button -> Maybe (M1 Velocity)
button (Button _ Pressed) = Just (M1 (Velocity 0 1))
button (Button _ Released) = Nothing

circle :: Position -> M2 Velocity
circle _ = M2 (Velocity 0.2 0.2)

main :: IO ()
main = simulate (button, circle, muxVelocity)
