data State
  = Searching
  | Approaching Double
  | Escaping { since :: Seconds, wayOut :: Side }
  | Finished

data Side = L | R

step :: State -> Seconds -> State
step Searching _ = Approaching 0.2
step (Approaching v) now
  | v > 0.5 = Escaping { since = now, wayOut = L }
  | otherwise = Approaching (v + 0.05)
step s@(Escaping t side) now =
  if now - t > 3
    then Finished
    else case side of
      L -> s
      R -> s { wayOut = L }
step Finished _ = Finished

run :: Memory State -> Seconds -> (Memory State, Velocity)
run (Memory s) now = (Memory s', speed s')
  where
    s' = step s now
    speed (Approaching v) = Velocity v 0
    speed Escaping { wayOut = L } = Velocity 0 1
    speed Escaping { wayOut = R } = Velocity 0 (-1)
    speed _ = Velocity 0 0

main :: IO ()
main = simulate run
