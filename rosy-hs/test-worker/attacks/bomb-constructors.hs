data Many
  = C0
FROM 1 TO 2999:  | CNUMBER
  deriving (Eq, Ord, Show, Read, Enum, Bounded)

main = simulate (Say (show [minBound .. maxBound :: Many]))
