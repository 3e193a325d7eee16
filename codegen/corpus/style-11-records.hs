{-# LANGUAGE NamedFieldPuns #-}
{-# LANGUAGE RecordWildCards #-}
-- Records: made, taken apart, changed.
data Robot = Robot
  { name      :: String
  , speed     :: Double   -- ^ metres a second
  , goal      :: (Double, Double)
  , history   :: [Maybe (Double, Double)]
  , onArrival :: Double -> Velocity
  }

start :: Robot
start = Robot
  { name = "rosy"
  , speed = 0.3
  , goal = (1, 2)
  , history = []
  , onArrival = \v -> Velocity (v / 2) 0
  }

faster, slower :: Robot -> Robot
faster r = r { speed = speed r * 2, name = name r ++ "!" }
slower r@Robot { speed = s } = r { speed = s / 2 }

title :: Robot -> String
title Robot {name} = name

line :: Robot -> String
line Robot {..} = name ++ " " ++ show speed

fresh :: String -> Robot
fresh name = Robot {..}
  where
    speed = 0.1
    goal = (0, 0)
    history = [Nothing]
    onArrival = const (Velocity 0 0)

twice :: Robot -> Robot
twice = faster . faster . \r -> r { history = Nothing : history r }

deep :: Robot -> Double
deep = fst . goal . (\r -> r { goal = (snd (goal r), 0) }) . slower

empty' :: Robot -> Bool
empty' Robot {} = True

main = simulate (onArrival start (speed (faster start {speed = 1})))
