{-
   Program: dance
   Author:  class 7b
-}

-- how fast it dances
speed :: Double   -- in m/s
speed = 0.2       -- not too fast!

{- dance to the left -}
left :: Velocity
left = Velocity 0 {- no forward -} speed -- just turn

-- dance to the right
right :: Velocity
right = Velocity 0 (-speed)

-- the whole dance
dance :: Task ()
dance = do
  -- first to the left
  say "left!" -- shout
  task left tick
  -- then to the right
  say "right!"
  task right tick
  -- and again
  dance
  -- never reached

tick :: Done ()
tick = Done ()

-- end of program?
main :: IO ()
main = simulate dance
-- yes, the end.
