{-# LANGUAGE LambdaCase #-}
-- Nine inputs and nine outputs, Either nested, one sided, Never, Clock, Param
type Hit = Either BumperLeft (Either BumperCenter BumperRight)

which :: Hit -> Param Int -> (Say, Param Int)
which h (Param n) = (Say (side h ++ show n), Param (n + 1))
  where
    side = \case
      Left _ -> "L"
      Right (Left _) -> "C"
      Right (Right _) -> "R"

nine :: (Velocity, Position, Orientation, Pose, Seconds, Clock, Memory Int, Param Int, StdGen) -> (Memory Int, Maybe Say, Maybe Led1, Maybe Led2, [Sound], (), Either Say Led1, Maybe Never, Maybe (Param Int))
nine (Velocity v _, Position x _, o, Pose _ _, t, Clock h m s ms, Memory n, Param p, g) =
  ( Memory (n + 1), if n == 3 then Just (Say (show (h, m, s, p))) else Nothing, Nothing, Nothing, [], (), if n == 4 then Left (Say "four") else Right (Led1 Black), Nothing, Nothing )

never :: Never -> Say
never Never = Say "never"

main = simulate ((which, nine), [never], Velocity 0.3 0)
