data Wide = Wide
  { f0 :: Int
FROM 1 TO 1499:  , fNUMBER :: Int
  }
  deriving (Eq, Ord, Show, Read)

main = simulate (Say "made")
