-- have we hit something yet?
type Hit = Bool

bump :: Bumper -> Memory Hit
bump _ = Memory True

forwardBackward :: Memory Hit -> Velocity -> Velocity
forwardBackward (Memory hit) (Velocity vl va)
  | hit = Velocity (vl - 0.5) va
  | otherwise = Velocity (vl + 0.5) va

main :: IO ()
main = simulate (bump, forwardBackward)
