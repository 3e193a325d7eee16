main :: IO ()
main = simulate
  [ Left bump
  , Right cliff
  ]

bump :: Bumper -> Sound
bump _ = ErrorSound

cliff :: Cliff -> Sound
cliff _ = OffSound
