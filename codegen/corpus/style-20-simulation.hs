-- A cleaning robot, as somebody with experience writes it.
data Mode
  = Spiral Double Seconds
  | Bounce Direction
  | Follow { side :: Direction, since :: Seconds }
  | Halt

data Direction = L | R deriving (Eq, Show, Enum, Bounded)

data Obstacle = Obstacle Direction

-- | Bumpers and cliffs count alike.
notice :: Either Bumper Cliff -> Maybe Obstacle
notice (Left (Bumper s Pressed)) = Just . Obstacle $ case s of
  LeftBumper -> L
  _ -> R
notice (Right (Cliff s Hole)) = Just (Obstacle (if isLeft s then L else R))
  where
    isLeft LeftCliff = True
    isLeft _ = False
notice _ = Nothing

lifted :: Wheel -> Maybe (Memory Mode)
lifted (Wheel _ Air) = Just (Memory Halt)
lifted (Wheel _ Ground) = Just (Memory (Spiral 0.1 0))

change :: Obstacle -> StdGen -> Seconds -> Memory Mode -> Memory Mode
change (Obstacle d) gen now (Memory mode) = Memory $ case mode of
  Halt -> Halt
  Follow {side = s, since = t}
    | now - t > 10, s == d -> Bounce d
    | now - t > 10 -> Follow {side = d, since = now}
  _ | chance < 0.3 -> Follow {side = d, since = now}
    | otherwise -> Bounce (other d)
  where
    (chance, _) = randomR (0, 1 :: Double) gen
    other L = R
    other R = L

drive :: Memory Mode -> Seconds -> Velocity
drive (Memory mode) now =
  case mode of
    Spiral r t -> let w = 1 / (r + 0.01 * realToFrac (now - t)) in Velocity 0.2 w
    Bounce d -> Velocity 0 $ sign d * 1.2
    Follow {side = d} -> Velocity 0.15 (sign d * 0.4)
    Halt -> Velocity 0 0
  where
    sign :: Direction -> Double
    sign L = -1
    sign R = 1

lights :: Memory Mode -> (Led1, Led2)
lights (Memory m) = both (colour m)
  where
    both c = (Led1 c, Led2 c)
    colour Halt = Red
    colour Follow {} = Orange
    colour _ = Green

main :: IO ()
main = simulate ((notice, lifted), (change, drive), [lights])
