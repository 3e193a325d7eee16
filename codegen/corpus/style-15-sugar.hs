{-# LANGUAGE LambdaCase, MultiWayIf, TupleSections, BlockArguments #-}
-- Sugar that blocks do without.
tagged :: [Int] -> [(String, Int)]
tagged = map ("n",)

gaps :: Int -> (Int, String, Bool)
gaps = (, "x", True)

react :: Bumper -> Maybe Sound
react = \case
  Bumper LeftBumper Pressed -> Just ErrorSound
  Bumper _ Pressed -> Just ButtonSound
  _ -> Nothing

level :: Double -> LedColor
level d = if
  | d < 0.3 -> Red
  | d < 1 -> Orange
  | otherwise -> Green

looks :: Either Int String -> Task ()
looks e = case e of
  Left n -> if | n > 0 -> say "plus"
               | n < 0 -> say "minus"
               | otherwise -> pure ()
  Right s -> flip mapM_ (words s) \w -> say w

steps :: Task ()
steps = do
  when True do
    say "a"
    wait 1
  forM_ [1, 2 :: Int] \n -> do
    say (show n)
  say "b"

main = simulate (react, steps `seq` Led1 (level 1))
