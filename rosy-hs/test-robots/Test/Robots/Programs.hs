{-# OPTIONS_GHC -fno-omit-yields #-}

-- |
-- Description : Programs that the tests drive robots with.
module Test.Robots.Programs (byName, follow, lights, sounds) where

import Rosy

-- | A program by its name on the command line.
byName :: String -> IO ()
byName n = case n of
  "steady" -> simulate steady
  "lights" -> simulate (steady, lights)
  "fails" -> simulate (steady, failing)
  "hangs" -> simulate (steady, hanging)
  "done" -> simulate (task steady pressed)
  _ -> errorWithoutStackTrace ("no program is called " ++ n)

-- | Forwards at the default rate.
steady :: Velocity
steady = Velocity 0.2 0

failing :: Bumper -> Led1
failing _ = error "the bumper broke me"

hanging :: Bumper -> Led1
hanging = hanging

pressed :: Bumper -> Done ()
pressed _ = Done ()

-- | A command for every odometry message: faster than now.
follow :: Velocity -> Position -> Velocity
follow (Velocity v w) (Position x _) = Velocity (v + 0.125) (w / 2 + x / 8)

lights :: Bumper -> Led1
lights (Bumper _ Pressed) = Led1 Red
lights (Bumper _ Released) = Led1 Black

sounds :: Either Cliff Button -> Maybe Sound
sounds e = case e of
  Left (Cliff _ Hole) -> Just ErrorSound
  Right (Button Button0 Pressed) -> Just OnSound
  _ -> Nothing
